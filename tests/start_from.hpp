#pragma once
// Starts a scene from the end of another run: every voxel takes the mean amounts that were found there.
#include "memory_sink.hpp"

namespace shmoo::test {

// `scene` has `of`'s particles on a lattice of `spacing` [m]; `time` is the record to start from.
inline void start_from(const Laboratory& of, std::size_t time, double spacing, scene::Scene& scene) {
  scene.initials.clear();
  const auto places = of.experiment->start_position();
  const auto& volume = of.shared.at("volume", 0);
  for (std::size_t s = 0; s < scene.species.size(); ++s) {
    const auto& amount = of.shared.at(scene.species[s].name, time);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (amount[i] <= 0.0) continue;  // the solver may leave a little less than nothing
      scene::BoxShape cell{{0, 0, 0}, {0, 0, 0}};
      for (std::size_t a = 0; a < std::size_t(scene.dimension); ++a) {
        cell.lower[a] = places[i][a] - 0.5 * spacing;
        cell.upper[a] = places[i][a] + 0.5 * spacing;
      }
      scene::Initial initial;
      initial.species = int(s);
      initial.shape = std::make_shared<scene::Shape>(scene::Shape{cell});
      initial.concentration.value = amount[i] / volume[i];
      scene.initials.push_back(initial);
    }
  }
}

}  // namespace shmoo::test
