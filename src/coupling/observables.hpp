#pragma once
// The named observables of a scene, measured on one state or one picture of the flow.
#include <vector>

#include "coupling/frame.hpp"
#include "coupling/geometry.hpp"
#include "coupling/record.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

bool of_chemistry(scene::ObservableType type);

// What one observable looks like in the result; `cells` is the number of particles along its axis (the default of
// bins).
FieldInfo describe(const scene::Observable& observable, const scene::Scene& scene, std::size_t cells);

// Molecules or concentrations at the end of the frame's interval. Fills whole numbers into `counts` where the
// observable counts molecules of a stochastic species, reals into `reals` otherwise.
template <int D>
void measure_chemistry(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                       const rdme::State& state, const Frame<D>& frame, const Geometry<D>& geometry,
                       std::vector<std::int64_t>& counts, std::vector<double>& reals);

// The part of it that needs no geometry: sums of a species over each bin, or over all that the observable selects.
template <int D>
void measure_sums(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                  const rdme::State& state, const Frame<D>& frame, const std::vector<std::uint16_t>& material,
                  std::vector<std::int64_t>& counts, std::vector<double>& reals);

// `number` is the observable's among the scene's.
template <int D>
void measure_flow(const scene::Observable& observable, const scene::Scene& scene, const FieldInfo& info,
                  const FlowPicture<D>& picture, const std::vector<std::uint16_t>& material, std::vector<double>& reals,
                  std::size_t number);

}  // namespace shmoo::coupling
