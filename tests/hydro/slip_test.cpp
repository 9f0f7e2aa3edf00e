// Slip sides are mirrors: nothing rubs on them and nothing passes.
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

scene::Scene mirrored_scene(scene::Scene scene, int axis) {
  for (auto& side : scene.domain.sides[std::size_t(axis)]) side.type = scene::SideType::slip;
  return scene;
}

template <int D>
void stream_keeps_its_velocity() {
  auto scene = mirrored_scene(box_scene(D, 1.0, D == 2 ? 0.05 : 0.1, 0.1), 1);
  scene.domain.jitter = 0.2;
  scene.flow.initial_velocity.assign(D, {0.0, "0"});
  scene.flow.initial_velocity[0].expression = "1";
  scene.flow.reference_speed = 1.0;
  auto fluid = make_fluid<D>(scene);
  const double start = fluid.momentum()[0];
  for (int k = 0; k < 200; ++k) fluid.step();
  // What is lost along the side is what the shift's correction loses, which is none for a uniform stream.
  EXPECT_NEAR(fluid.momentum()[0], start, 1e-3 * start);
  for (const auto i : fluid.state().rows.fluid()) EXPECT_NEAR(fluid.velocity(i)[0], 1.0, 0.05);
}

}  // namespace

TEST(Slip, AStreamOnTheLatticeKeepsItsVelocityToRoundOff) {
  auto scene = mirrored_scene(box_scene(2, 1.0, 0.05, 0.1), 1);
  scene.flow.initial_velocity = {{1.0, ""}, {0.0, ""}};
  auto fluid = make_fluid<2>(scene);
  fluid.advance(2.0);
  for (const auto i : fluid.state().rows.fluid()) {
    EXPECT_NEAR(fluid.velocity(i)[0], 1.0, 1e-11);
    EXPECT_NEAR(fluid.velocity(i)[1], 0.0, 1e-11);
  }
}

TEST(Slip, AStreamOfDisorderedParticlesLosesNothing2D) { stream_keeps_its_velocity<2>(); }
TEST(Slip, AStreamOfDisorderedParticlesLosesNothing3D) { stream_keeps_its_velocity<3>(); }

// Without the shift, pair forces are all that acts, and those across a mirror add up to nothing along it.
TEST(Slip, BearsNoShearStress) {
  auto scene = mirrored_scene(box_scene(2, 1.0, 0.05, 0.1), 1);
  scene.domain.jitter = 0.2;
  scene.effects.transport_velocity = false;
  scene.flow.initial_velocity = {{0.0, "1 + 0.5*cos(_pi*y)"}, {0.0, "0"}};
  auto fluid = make_fluid<2>(scene);
  const double start = fluid.momentum()[0];
  for (int k = 0; k < 200; ++k) fluid.step();
  EXPECT_NEAR(fluid.momentum()[0], start, 1e-12 * start);
}

// A box with mirrors is the half of a periodic box whose other half is its image.
TEST(Slip, AMirroredBoxIsHalfOfASymmetricOne) {
  auto whole = box_scene(2, 1.0, 0.05, 0.1);
  whole.flow.initial_velocity = {{0.0, "sin(2*_pi*x)*cos(2*_pi*y)"}, {0.0, "-cos(2*_pi*x)*sin(2*_pi*y)"}};
  whole.flow.reference_speed = whole.flow.reference_length = 1.0;
  auto half = mirrored_scene(whole, 1);
  half.domain.upper[1] = 0.5;
  auto first = make_fluid<2>(whole), second = make_fluid<2>(half);
  for (int k = 0; k < 100; ++k) first.step(), second.step();
  EXPECT_NEAR(second.kinetic_energy() / first.kinetic_energy(), 0.5, 1e-6);
}

TEST(Slip, TheImplicitViscousStepIsNeitherChosenNorTaken) {
  auto scene = mirrored_scene(box_scene(2, 1.0, 0.05, 100.0), 1);
  scene.flow.reference_speed = 0.01;
  EXPECT_NO_THROW(make_fluid<2>(scene).step());
  scene.numerics.viscous_step = scene::ViscousStep::implicit_step;
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);
}

TEST(Slip, NothingPasses) {
  auto scene = mirrored_scene(mirrored_scene(box_scene(2, 1.0, 0.05, 0.01), 0), 1);
  scene.flow.initial_velocity = {{0.0, "3*sin(5*x)"}, {0.0, "4*cos(7*x*y)"}};
  scene.flow.reference_speed = 1.0;
  auto fluid = make_fluid<2>(scene);
  fluid.advance(1.0);
  for (const auto i : fluid.state().rows.fluid())
    for (int a = 0; a < 2; ++a) {
      EXPECT_GE(fluid.particles().position[i][a], 0.0);
      EXPECT_LE(fluid.particles().position[i][a], 1.0);
    }
}

}  // namespace shmoo::hydro::testing
