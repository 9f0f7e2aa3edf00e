#include "run/explain/coarse_wall.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "run/recorder.hpp"
#include "scene/motion.hpp"

namespace shmoo::run {
namespace {

constexpr double layers = 3;
constexpr int columns = 40;

// [m], or 0 where the wall is no ring.
double thickness(const scene::Scene& scene) {
  for (const auto& region : scene.regions)
    if (const auto* ring = std::get_if<scene::ShellShape>(&region.shape->form)) return ring->outer - ring->inner;
  return 0.0;
}

// To the end of the run, at the pace of the last steps.
void go_on(std::vector<Moment>& course) {
  if (course.size() < 4) return course.clear();
  const Moment last = course.back(), before = course[course.size() * 3 / 4];
  if (!(last.fraction < 1.0) || !(last.fraction > before.fraction)) return;
  const double pace = (last.seconds - before.seconds) / (last.fraction - before.fraction);
  course.push_back({1.0, last.seconds + pace * (1.0 - last.fraction)});
}

double seconds_at(const std::vector<Moment>& course, double fraction) {
  const auto above = std::lower_bound(course.begin(), course.end(), fraction,
                                      [](const Moment& moment, double f) { return moment.fraction < f; });
  if (above == course.end()) return course.back().seconds;
  const Moment below = above == course.begin() ? Moment{} : *std::prev(above);
  const double part = (fraction - below.fraction) / (above->fraction - below.fraction);
  return below.seconds + part * (above->seconds - below.seconds);
}

}  // namespace

std::vector<Moment> coarse_course(const scene::Scene& scene, const Maker& make, double budget) {
  scene::Scene coarse = scene;
  coarse.domain.spacing = thickness(scene) / layers;
  coarse.mechanics.columns = columns;
  if (!scene::quasi_static(scene) || !(coarse.domain.spacing > scene.domain.spacing)) return {};
  std::vector<Moment> course;
  double begin = base::cpu_seconds();
  const auto spent = [&] { return base::cpu_seconds() - begin; };
  try {
    const auto experiment = make(coarse);
    Recorder recorder(experiment->layout(), Recorder::Source::preparation);
    begin = base::cpu_seconds();
    experiment->prepare(recorder, {[&] { return spent() > budget; },
                                   [&](double f) {
                                     course.push_back({f, spent()});
                                   }});
  } catch (const base::RunError&) {  // the coarse wall bears less
    return {};
  } catch (const base::InputError&) {
    return {};
  }
  go_on(course);
  return course;
}

double by_coarse(const std::vector<Moment>& played, const std::vector<Moment>& coarse) {
  const Moment& last = played.back();
  const double until = seconds_at(coarse, last.fraction);
  return last.seconds * coarse.back().seconds / until;
}

}  // namespace shmoo::run
