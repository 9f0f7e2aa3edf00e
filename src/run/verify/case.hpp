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
  bool holds() const { return std::isfinite(value) && value >= lowest && value <= highest; }
};

inline Finding at_most(std::string law, double value, double bound) {
  return {std::move(law), value, -std::numeric_limits<double>::infinity(), bound};
}
inline Finding at_least(std::string law, double value, double bound) {
  return {std::move(law), value, bound, std::numeric_limits<double>::infinity()};
}
inline Finding within(std::string law, double value, double lowest, double highest) {
  return {std::move(law), value, lowest, highest};
}
inline Finding exactly(std::string law, double value, double wanted) { return {std::move(law), value, wanted, wanted}; }

// How far a mean of random numbers may lie from its law, in standard errors: a false alarm in 1.7 million.
constexpr double most_errors = 5.0;
inline Finding standard_errors(std::string law, double value) {
  return {std::move(law) + ", in standard errors", value, -most_errors, most_errors};
}

struct Case {
  std::string name;
  std::string what;  // makes it hard
  std::function<std::vector<Finding>()> run;
};

// Hard cases, run to a long time and judged by laws instead of by not crashing.
std::vector<Case> stability_cases();

// Every sampler against exact laws of small networks, chi-square of whole distributions. A law that holds is called
// broken in one of a million runs of each.
std::vector<Case> chemistry_cases(std::uint64_t seed);

// Parts of the stability cases, by what they strain.
std::vector<Case> hard_starts();      // where particles stand at the start
std::vector<Case> hard_flows();       // forces, walls, noise
std::vector<Case> hard_chemistry();   // numbers of molecules and rates
std::vector<Case> hard_splittings();  // steps that are too long or must shorten

}  // namespace shmoo::run::verify
