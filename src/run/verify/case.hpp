#pragma once
// A case of verification: a scene that is run and the laws it is judged by. A law is a number and the interval it must
// lie in; a number that is no number breaks every law.
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace shmoo::run::verify {

struct Finding {
  std::string law;
  double value = 0;
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
  double false_alarm = 0;  // the chance that a right program breaks it, where it is of random numbers
  bool holds() const { return std::isfinite(value) && value >= lowest && value <= highest; }
};

inline Finding at_most(std::string law, double value, double bound) {
  return {std::move(law), value, -std::numeric_limits<double>::infinity(), bound, 0.0};
}
inline Finding at_least(std::string law, double value, double bound) {
  return {std::move(law), value, bound, std::numeric_limits<double>::infinity(), 0.0};
}
inline Finding within(std::string law, double value, double lowest, double highest) {
  return {std::move(law), value, lowest, highest, 0.0};
}
inline Finding exactly(std::string law, double value, double wanted) {
  return {std::move(law), value, wanted, wanted, 0.0};
}
// A number that is uniform in [0, 1] where the law holds.
inline Finding chance(std::string law, double value, double least) {
  return {std::move(law), value, least, std::numeric_limits<double>::infinity(), least};
}

// How far a mean of random numbers may lie from its law, in standard errors.
constexpr double most_errors = 5.0;
inline Finding standard_errors(std::string law, double value) {
  return {std::move(law) + ", in standard errors", value, -most_errors, most_errors,
          std::erfc(most_errors / std::sqrt(2.0))};
}

struct Case {
  std::string name;
  std::string what;  // makes it hard
  std::function<std::vector<Finding>()> run;
  bool by_name_only = false;  // takes long, or does not hold yet
};

// Hard cases, run to a long time and judged by laws instead of by not crashing.
std::vector<Case> stability_cases();

// Every sampler against exact laws of small networks: chi-square of whole distributions, or means where only these are
// known. A law of random numbers that holds is called broken in one of a million runs.
std::vector<Case> chemistry_cases(std::uint64_t seed);

// Parts of the stability cases, by what they strain.
std::vector<Case> hard_starts();      // where particles stand at the start
std::vector<Case> hard_flows();       // forces, walls, noise
std::vector<Case> hard_openings();    // particles that enter and leave
std::vector<Case> hard_solids();      // elastic solids in a fluid
std::vector<Case> hard_walls();       // shocks and tears
std::vector<Case> hard_shots();       // fluid shot at walls
std::vector<Case> hard_shells();      // elastic walls in equilibrium
std::vector<Case> hard_chemistry();   // numbers of molecules and rates
std::vector<Case> hard_rates();       // extremes of both
std::vector<Case> hard_splittings();  // steps that are too long or must shorten

}  // namespace shmoo::run::verify
