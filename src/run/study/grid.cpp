#include "run/study/grid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "base/error.hpp"
#include "base/sha256.hpp"

namespace shmoo::run::study {
namespace {

using scene::Scene;

bool is_random(const Scene& scene) {
  bool random = scene.effects.flow && scene.effects.thermal_noise;
  for (const auto& species : scene.species) random = random || species.method != scene::SpeciesMethod::deterministic;
  return random;
}

double particles(const Scene& scene) {
  double count = 1.0;
  for (int a = 0; a < scene.dimension; ++a)
    count *= (scene.domain.upper[std::size_t(a)] - scene.domain.lower[std::size_t(a)]) / scene.domain.spacing;
  return count;
}

// What is taken from a result; regions, references and norms are applied later and may change freely.
std::string taken_text(const scene::Study& study) {
  std::string text;
  for (const auto& q : study.quantities) {
    text += fmt::format("{} {} {} {}", q.field, q.observable, q.component, fmt::join(q.times, ","));
    if (q.average) text += fmt::format(" {} {}", (*q.average)[0], (*q.average)[1]);
    if (q.amplitude) text += fmt::format(" amplitude {} {}", (*q.amplitude)[0], (*q.amplitude)[1]);
    if (q.period) text += fmt::format(" period {} {}", (*q.period)[0], (*q.period)[1]);
    if (q.harmonic) text += fmt::format(" harmonic {} {}", (*q.harmonic)[0], (*q.harmonic)[1]);
    if (q.harmonic_period)
      text += fmt::format(" harmonic_period {} {}", (*q.harmonic_period)[0], (*q.harmonic_period)[1]);
    text += '\n';
  }
  return text;
}

// Levels and methods are far apart in the seeds, so that no two runs share random numbers.
std::uint64_t seed_of(std::uint64_t model_seed, const Task& task) {
  return model_seed + task.repeat + 10'000 * task.method + 1'000'000 * task.level;
}

Task task_of(const scene::Study& study, std::size_t method, std::size_t level, const std::string& taken) {
  const auto& how = study.methods[method];
  Task task{.method = method, .level = level};
  task.overrides = study.levels[level].set;
  task.overrides.insert(task.overrides.end(), how.set.begin(), how.set.end());
  const auto scene = scene::read_scene(study.model, task.overrides);
  task.random = is_random(scene);
  task.dimension = scene.dimension;
  task.realisations = task.random ? how.realisations.value_or(std::size_t(scene.run.realisations)) : 1;
  task.work = particles(scene) * double(task.realisations);
  task.model_text = scene.text;
  task.seed = scene.run.seed;
  task.key = taken;
  return task;
}

}  // namespace

std::vector<Task> tasks_of(const scene::Study& study) {
  std::vector<Task> tasks;
  std::vector<base::Diagnostic> mistakes;
  std::set<std::string> told;
  const auto taken = taken_text(study);
  for (std::size_t m = 0; m < study.methods.size(); ++m)
    for (std::size_t l = 0; l < study.levels.size(); ++l) {
      if (!study.methods[m].levels[l]) continue;
      try {
        const auto first = task_of(study, m, l, taken);
        for (std::size_t r = 0; r < (first.random ? study.methods[m].repeats : 1); ++r) {
          auto task = first;
          task.repeat = r;
          task.seed = seed_of(first.seed, task);
          task.name = fmt::format("{}-{}-{}", study.methods[m].name, l + 1, r + 1);
          task.key = base::sha256(
              fmt::format("{}\n{}\n{} {} {}", taken, task.model_text, task.seed, task.realisations, study.budget));
          tasks.push_back(std::move(task));
        }
      } catch (const base::InputError& error) {
        for (const auto& mistake : error.diagnostics())
          if (told.insert(mistake.text()).second)
            mistakes.push_back({mistake.where, fmt::format("{} (method {}, level {})", mistake.message,
                                                           study.methods[m].name, study.levels[l].name)});
      }
    }
  if (!mistakes.empty()) throw base::InputError(std::move(mistakes));
  for (const auto& quantity : study.quantities)
    for (const auto& task : tasks) {
      for (const auto& parameter : quantity.reference.parameters) resolved(parameter, task);
      if (quantity.reference.value) resolved(*quantity.reference.value, task);
      if (quantity.scale) resolved(*quantity.scale, task);
    }
  return tasks;
}

double resolved(const scene::StudyNumber& number, const Task& task) {
  if (number.path.empty()) return number.value;
  const auto fail = [&](const std::string& why) {
    throw base::InputError(std::vector<base::Diagnostic>{
        {number.where,
         fmt::format("{}: {}; give a number with its unit, or the path of a key of the model", number.path, why)}});
  };
  base::Measured measured;
  try {
    measured = scene::number_in_model(task.model_text, number.path);
  } catch (const std::exception& error) {
    fail(error.what());
  }
  if (number.dimension != base::dimensions::none && measured.dimension != number.dimension)
    fail(fmt::format("the model says {} there, and {} is needed", base::dimension_name(measured.dimension),
                     base::dimension_name(number.dimension)));
  return measured.value;
}

}  // namespace shmoo::run::study
