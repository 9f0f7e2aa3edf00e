#pragma once
// An experiment of `shmoo verify chemistry`: a small model whose numbers have a known law, by every sampler.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "coupling/laboratory.hpp"
#include "run/verify/case.hpp"

namespace shmoo::run::verify {

// Each realisation gives one number, at the end: molecules of `species` in the first `voxels` of the row.
struct Experiment {
  std::string model;
  std::string species;
  std::vector<double> law{};                               // of that number: chi-square of the distribution;
  double mean = std::numeric_limits<double>::quiet_NaN();  // or, where there is none, its mean
  std::string minus{};                                     // a species whose molecules count negative
  std::size_t voxels = ~std::size_t{0};
  int realisations = 4000;
  std::vector<std::string> samplers{"direct", "composition_rejection", "split", "tau_leaping"};
};

// The largest chance at which a law is called broken that holds.
constexpr double false_alarm = 1e-6;

std::vector<Finding> judge(const Experiment& experiment, std::uint64_t seed);

// `voxels` of one cubic metre in a row, to the time `until`, with splitting steps of `step`.
std::string row_of(int voxels, const std::string& chemistry, const std::string& until, const std::string& step);
std::string species(const std::string& name, int initial, const std::string& diffusivity = "1 m^2/s");
std::string reaction(const std::string& equation, const std::string& forward, const std::string& backward = "");
std::string custom_reaction(const std::string& equation, const std::string& rate);
// `count` molecules at the start in voxels [from, to) only
std::string start_in(const std::string& species, int count, int from, int to);

std::vector<double> binomial_law(int n, double p);
std::vector<double> poisson_law(double mean, int largest);

struct NamedExperiment {
  const char* name;
  const char* what;
  Experiment (*make)();
};
std::vector<NamedExperiment> reactions_alone();
std::vector<NamedExperiment> walkers();
std::vector<NamedExperiment> meetings();

std::vector<Finding> min_oscillations(std::uint64_t seed);

}  // namespace shmoo::run::verify
