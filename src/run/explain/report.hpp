#pragma once
// What `shmoo explain` says of a model, and how it is said.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "coupling/experiment.hpp"
#include "coupling/rules/decide.hpp"
#include "coupling/rules/limits.hpp"
#include "run/explain/forecast.hpp"

namespace shmoo::run {

// A dimensionless or other number that tells what kind of a model it is.
struct Telling {
  std::string name;
  double value = 0;
  std::string unit, meaning;
};

struct Report {
  coupling::Decided decided;
  std::vector<Telling> numbers;
  std::vector<coupling::Limit> limits;
  std::vector<coupling::Experiment::Derived> derived;
  std::optional<coupling::FlowCosts> flow;  // where there is one, and it was measured
  std::optional<Forecast> forecast;
};

std::vector<Telling> telling_numbers(const scene::Scene& scene, const coupling::Numbers& numbers);

std::string as_text(const Report& report);
nlohmann::json as_json(const Report& report);

}  // namespace shmoo::run
