// Where materials touch, and what passes between them.
#include "rdme/surface/contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"
#include "sph/fill.hpp"

namespace {

using namespace shmoo;

template <int D>
double area_of(const std::string& model) {
  const auto scene = scene::read_scene_text(model, "surface.toml");
  const auto filling = sph::fill<D>(scene);
  const std::vector<base::Vec<D>> position(filling.particles.position.values().begin(),
                                           filling.particles.position.values().begin() + long(filling.voxels));
  const std::vector<std::uint16_t> material(filling.particles.material.values().begin(),
                                            filling.particles.material.values().begin() + long(filling.voxels));
  const std::vector<double> cells(position.size(), filling.cell);
  const rdme::Places<D> places{position, cells, {}, material, filling.vacant};
  const auto surface = rdme::make_surface<D>(places, filling.box, std::pow(filling.cell, 1.0 / D), scene.depth, {1, 0});
  for (std::size_t i = 0; i < position.size(); ++i) {
    double sum = 0.0;
    for (auto p = surface.first[i]; p < surface.first[i + 1]; ++p) sum += surface.share[p];
    EXPECT_TRUE(surface.first[i] == surface.first[i + 1] || std::abs(sum - 1.0) < 1e-12);
  }
  return std::accumulate(surface.area.begin(), surface.area.end(), 0.0);
}

std::string square(const std::string& spacing, const std::string& jitter, const std::string& shape) {
  return "title = \"Two materials\"\ndimension = 2\ndepth = \"2 m\"\n[domain]\nsize = [\"1 m\", \"1 m\"]\nspacing = "
         "\"" +
         spacing + "\"\njitter = " + jitter +
         "\nmaterial = \"medium\"\n[materials.medium]\ntype = \"still\"\n[materials.wall]\ntype = "
         "\"still\"\n[[region]]\n"
         "material = \"wall\"\n" +
         shape + "[run]\nuntil = \"1 s\"\n";
}

const std::string slab = "shape = \"box\"\nlower = [\"0 m\", \"0 m\"]\nupper = [\"1 m\", \"0.25 m\"]\n";
const std::string slope = "shape = \"half_space\"\npoint = [\"0.5 m\", \"0.5 m\"]\nnormal = [1, 1]\n";
const std::string disk = "shape = \"disk\"\ncenter = [\"0.5 m\", \"0.5 m\"]\nradius = \"0.3 m\"\n";

TEST(Contacts, OfAPlaneAddUpToItsArea) { EXPECT_NEAR(area_of<2>(square("0.05 m", "0.0", slab)), 2.0, 1e-9); }

TEST(Contacts, OfAStaircaseAddUpToTheSlopeItStandsFor) {
  EXPECT_NEAR(area_of<2>(square("0.02 m", "0.0", slope)), 2.0 * std::numbers::sqrt2, 0.02 * 2.83);
}

TEST(Contacts, OfADiskAddUpToItsCircumference) {
  const double circumference = 2.0 * std::numbers::pi * 0.3 * 2.0;
  EXPECT_NEAR(area_of<2>(square("0.01 m", "0.0", disk)), circumference, 0.03 * circumference);
  EXPECT_NEAR(area_of<2>(square("0.01 m", "0.2", disk)), circumference, 0.03 * circumference);
}

// A slab of length 1 m, closed at the left, that loses k_s C to the wall at its right: the profile cos(a x) decays at
// the rate D a^2 where a tan(a) = k_s/D. Concentrations stand half a voxel from the wall: first order in the spacing.
double error_of_slab(int voxels) {
  const double h = 1.0 / voxels;
  const double a = 0.8603335890193797;  // a tan a = 1
  const auto scene = scene::read_scene_text(
      "title = \"A slab\"\ndimension = 1\ncross_section = \"1 m^2\"\n[domain]\nsize = [\"" + std::to_string(1.0 + h) +
          " m\"]\nspacing = \"" + std::to_string(h) + " m\"\nmaterial = \"medium\"\n" + R"toml(
[materials.medium]
type = "still"
[materials.wall]
type = "still"
[[region]]
material = "wall"
shape = "box"
lower = ["1 m"]
upper = ["2 m"]
[parameters]
a = "0.8603335890193797 1/m"
C0 = "1000 molecules/m^3"
[species.L]
in = "medium"
diffusivity = "1 m^2/s"
method = "deterministic"
initial = { expression = "C0 * cos(a*x)" }
[species.B]
in = "wall"
method = "deterministic"
[[reaction]]
equation = "L -> B"
surface = ["wall", "medium"]
forward = "1 m/s"
[numerics]
reach = 1.2
tolerance = 1e-9
[run]
until = "0.5 s"
record_every = "0.5 s"
)toml",
      "slab.toml");
  const coupling::Laboratory lab(scene);
  const auto& bound = lab.shared.at("B", 1);
  const double exact = 1000.0 * std::sin(a) / a * (1.0 - std::exp(-0.5 * a * a));
  return std::accumulate(bound.begin(), bound.end(), 0.0) / exact - 1.0;
}

TEST(SurfaceReaction, FluxConvergesToThatOfReactionAndDiffusion) {
  const double coarse = error_of_slab(16), fine = error_of_slab(32);
  EXPECT_LT(std::abs(fine), 0.02);
  EXPECT_NEAR(coarse / fine, 2.0, 0.2);
}

}  // namespace
