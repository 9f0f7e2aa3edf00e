#include <algorithm>
#include <numeric>

#include "coupling/laboratory.hpp"
#include "run/verify/case.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

using coupling::Laboratory;

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }
double least(const std::vector<double>& x) { return *std::min_element(x.begin(), x.end()); }

const std::string binding = R"toml(
title = "Binding, split far too coarsely"
dimension = 1
cross_section = "1 m^2"
[domain]
size = ["20 m"]
spacing = "1 m"
[materials.medium]
type = "still"
[species.A]
diffusivity = "1 m^2/s"
initial = "20 molecules/m^3"
[species.B]
diffusivity = "1 m^2/s"
initial = "20 molecules/m^3"
[species.C]
diffusivity = "1 m^2/s"
initial = "0 molecules/m^3"
[[reaction]]
equation = "A + B <-> C"
forward = "0.5 m^3/(s molecule)"
backward = "5 1/s"
[numerics]
reach = 1.2
sampler = "split"
[run]
until = "20 s"
record_every = "20 s"
)toml";

double splitting_step(const Laboratory& lab) {
  for (const auto& number : lab.experiment->derived()) {
    if (number.name == "splitting_step") return number.value;
  }
  return 0.0;
}

// The step is a hundred times what the program would take: the answer may be off, but stays an answer, and the run says
// that the step is too long.
std::vector<Finding> coarse_splitting() {
  const Laboratory fine(scene::read_scene_text(binding, "case.toml"));
  const double step = 100.0 * splitting_step(fine);
  const Laboratory coarse(scene::read_scene_text(binding, "case.toml",
                                                 {{"numerics.splitting_step", "\"" + std::to_string(step) + " s\""}}));
  double warned = 0.0, negative = 0.0, unbalanced = 0.0, conserved = 0.0;
  for (const auto& number : coarse.experiment->derived())
    warned += number.name.find("splitting") != std::string::npos && number.why.find("WARNING") != std::string::npos;
  for (std::uint32_t k = 0; k < 20; ++k) {
    coupling::Outcome outcome;
    const auto sink = coarse.realise(k, &outcome);
    for (const char* species : {"A", "B", "C"}) negative += least(sink.at(species, 1)) < 0.0;
    conserved += std::abs(sum(sink.at("A", 1)) + sum(sink.at("C", 1)) - 400.0);
    unbalanced += !outcome.balanced;
  }
  return {exactly("warnings that the splitting step is too long", warned, 1.0),
          exactly("negative numbers", negative, 0.0), exactly("A + C gained or lost", conserved, 0.0),
          exactly("ledgers that do not balance", unbalanced, 0.0)};
}

const std::string decay = R"toml(
title = "A decay that becomes a thousand times faster"
dimension = 1
cross_section = "1 m^2"
[domain]
size = ["10 m"]
spacing = "1 m"
[materials.medium]
type = "still"
[parameters]
k = "0.1 1/s"
jump = "5 s"
[species.A]
diffusivity = "0.01 m^2/s"
initial = "1000 molecules/m^3"
[[reaction]]
equation = "A -> nothing"
rate = "k * A * (1 + 999 * (t > jump))"
[numerics]
reach = 1.2
tolerance = 1e-8
[run]
until = "5.01 s"
record_every = "5.01 s"
)toml";

// A(5.01 s) = A(0) exp(-0.1 (5 + 1000 0.01)): every method must shorten its steps at t = 5 s by itself.
std::vector<Finding> sudden_rate() {
  const double exact = 10000.0 * std::exp(-1.5);
  std::vector<Finding> all;
  const Laboratory mean(scene::read_scene_text(decay, "case.toml", {{"species.A.method", "\"deterministic\""}}));
  all.push_back(
      at_most("error of the deterministic amount", std::abs(sum(mean.shared.at("A", 1)) / exact - 1.0), 1e-4));
  for (const char* sampler : {"direct", "composition_rejection", "split"}) {
    const Laboratory lab(
        scene::read_scene_text(decay, "case.toml", {{"numerics.sampler", "\"" + std::string(sampler) + "\""}}));
    constexpr int realisations = 40;
    double total = 0.0;
    for (std::uint32_t k = 0; k < realisations; ++k) total += sum(lab.realise(k).at("A", 1));
    const double p = std::exp(-1.5);
    all.push_back(standard_errors(std::string("mean amount, ") + sampler,
                                  (total / realisations - exact) / std::sqrt(10000.0 * p * (1 - p) / realisations)));
  }
  return all;
}

// A -> B -> C -> A around rates of 1e4, 1 and 1e-4 per second.
std::vector<Finding> stiff_rates() {
  const Laboratory lab(scene::read_scene_text(R"toml(
title = "A cycle of rates over eight decades"
dimension = 1
cross_section = "1 m^2"
[domain]
size = ["10 m"]
spacing = "1 m"
[materials.medium]
type = "still"
[species.A]
diffusivity = "1 m^2/s"
method = "deterministic"
initial = "1e6 molecules/m^3"
[species.B]
diffusivity = "1e-3 m^2/s"
method = "deterministic"
[species.C]
diffusivity = "1 m^2/s"
method = "deterministic"
[[reaction]]
equation = "A -> B"
forward = "1e4 1/s"
[[reaction]]
equation = "B -> C"
forward = "1 1/s"
[[reaction]]
equation = "C -> A"
forward = "1e-4 1/s"
[numerics]
reach = 1.2
tolerance = 1e-10
[run]
until = "2e5 s"
record_every = "2e5 s"
)toml",
                                              "case.toml"));
  const auto &a = lab.shared.at("A", 1), &b = lab.shared.at("B", 1), &c = lab.shared.at("C", 1);
  const double all = 1e7, weight = 1e-4 + 1.0 + 1e4;  // amounts stand as the inverse rates
  double wrong = std::abs(sum(a) / (all * 1e-4 / weight) - 1.0);
  wrong = std::max(wrong, std::abs(sum(b) / (all * 1.0 / weight) - 1.0));
  wrong = std::max(wrong, std::abs(sum(c) / (all * 1e4 / weight) - 1.0));
  return {at_most("error of the steady amounts", wrong, 1e-6),
          at_most("molecules lost or gained, of all", std::abs((sum(a) + sum(b) + sum(c)) / all - 1.0), 1e-9),
          at_least("smallest amount", std::min({least(a), least(b), least(c)}), 0.0)};
}

}  // namespace

std::vector<Case> hard_splittings() {
  return {{"coarse-splitting", "a splitting step a hundred times too long", coarse_splitting},
          {"sudden-rate", "a rate that jumps by a factor of a thousand in mid-run", sudden_rate},
          {"stiff-rates", "rates over eight decades", stiff_rates}};
}

}  // namespace shmoo::run::verify
