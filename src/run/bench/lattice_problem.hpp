#pragma once
// Networks on lattices whose stationary law is known, for the bench.
#include <array>
#include <cstdint>
#include <string>

#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::run::bench {

// A periodic lattice of n voxels of unit volume; a species of diffusivity 1 jumps to each neighbour at rate 1.
rdme::Voxels lattice(std::array<std::uint32_t, 3> n, std::size_t species);

scene::Scene diffusion_scene();                   // one species
scene::Scene binding_scene(double mean);          // A + B -> C at 9 A B/mean, C -> A + B at 9 C, all three diffuse
scene::Scene ring_scene(int species);             // X0 -> X1 -> ... -> X0 at rate 1, nothing diffuses
scene::Scene dimer_scene(double k, double back);  // 2 M -> D at k M (M - 1), D -> 2 M

// Every voxel starts with Poisson numbers of this mean: the stationary law given the totals, from the start.
void fill_poisson(rdme::State& state, double mean);

}  // namespace shmoo::run::bench
