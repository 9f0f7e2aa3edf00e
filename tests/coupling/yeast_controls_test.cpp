// The yeast projection's negative controls, coarse: what makes no projection, and how each fails. Figures beside them:
// an independent prototype of the same equations with six layers (models/yeast-projection/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

using scene::Overrides;

// Four layers and 44 columns.
scene::Scene coarse(const std::string& model, const std::string& until, const Overrides& more) {
  Overrides all{{"domain.spacing", "\"0.625 um\""},
                {"mechanics.columns", "44"},
                {"mechanics.step", "\"10 s\""},
                {"run.until", until},
                {"run.record_every", until}};
  all.insert(all.end(), more.begin(), more.end());
  return scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/yeast-projection/" + model, all);
}

struct Shape {
  double extension = 0;  // [m] of its length
  double aspect = 0;     // length over width, of the outermost particles
  double spread = 0;     // of the enzyme's concentration: (largest - smallest)/mean
  double cavity = 0;     // volume, over the volume at the start
};

Shape shape_of(const std::string& model, const std::string& until, const Overrides& more = {}) {
  const Laboratory lab(coarse(model, until, more));
  const auto &x = lab.shared.at("position", 1), &n = lab.shared.at("E", 1), &V = lab.shared.at("volume", 1);
  double left = 0, right = 0, width = 0, low = 1e300, high = 0, amount = 0, volume = 0;
  for (std::size_t i = 0; i < 4 * 44; ++i) {
    left = std::min(left, x[2 * i]), right = std::max(right, x[2 * i]), width = std::max(width, 2.0 * x[2 * i + 1]);
    low = std::min(low, n[i] / V[i]), high = std::max(high, n[i] / V[i]);
    amount += n[i], volume += V[i];
  }
  const auto observed = [&](const char* name, std::size_t t) { return lab.shared.observed(name, t)[0]; };
  return {observed("projection_length", 1), (right - left) / width, (high - low) / (amount / volume),
          observed("cavity", 1) / observed("cavity", 0)};
}

std::string refusal(const std::string& model, const std::string& until, const Overrides& more) {
  try {
    const Laboratory lab(coarse(model, until, more));
  } catch (const base::RunError& error) {
    return error.what();
  }
  return "";
}

// [s] at which a message says that it ended.
double time_of(const std::string& message) {
  const auto at = message.find("t = ");
  return at == std::string::npos ? -1.0 : std::stod(message.substr(at + 4));
}

const Overrides fast{{"species.E.diffusivity", "\"1e-12 m^2/s\""}};

// Prototype: uniform after a few hundred seconds, extension 0.075 um from 1000 s on, case I as case II.
TEST(YeastControls, APulseThatSoftensMakesNoProjection) {
  const auto one = shape_of("control-pulse.toml", "\"1000 s\""),
             two = shape_of("control-pulse.toml", "\"1000 s\"", fast);
  EXPECT_LT(std::abs(one.extension), 0.1e-6);
  EXPECT_LT(two.spread, 0.02);
  EXPECT_NEAR(one.extension, two.extension, 0.02e-6);
  EXPECT_NEAR(one.aspect, 1.0, 0.01);
}

// Prototype: the whole cell swells, aspect 1.003.
TEST(YeastControls, APulseWithGrowthSwellsTheWholeCell) {
  Overrides growth = fast;
  growth.insert(growth.end(), {{"materials.wall.growth.species", "\"E\""},
                               {"materials.wall.growth.coefficient", "\"0.1 m^3/(mol MPa s)\""}});
  const auto grown = shape_of("control-pulse.toml", "\"1000 s\"", growth);
  EXPECT_GT(grown.extension, 1e-6);
  EXPECT_GT(grown.cavity, 1.3);
  EXPECT_NEAR(grown.aspect, 1.0, 0.02);
}

// Prototype: -0.06 and 0.00 um.
TEST(YeastControls, ALocalisedSourceWithoutGrowthMakesNoProjection) {
  const Overrides none{{"materials.wall.growth.coefficient", "\"1e-9 m^3/(mol MPa s)\""}};
  for (const char* model : {"case-1.toml", "case-2.toml"})
    EXPECT_LT(std::abs(shape_of(model, "\"400 s\"", none).extension), 0.1e-6) << model;
}

// What the papers' input does: the enzyme held at the tip, none lost, a wall that only stretches. Prototype: no
// equilibrium after 240, 100 and 80 s at 0.003, 0.01 and 0.03 MPa.
TEST(YeastControls, AnElasticWallSoftenedWithoutEndFindsNoEquilibrium) {
  const auto end = [](const std::string& turgor) {
    return time_of(refusal("case-2.toml", "\"1000 s\"",
                           {{"materials.wall.growth.coefficient", "\"1e-9 m^3/(mol MPa s)\""},
                            {"reaction.0.forward", "\"1e-9 1/s\""},
                            {"mechanics.source.0.width", "\"2 um\""},
                            {"mechanics.turgor", turgor}}));
  };
  const double strong = end("\"0.03 MPa\""), weak = end("\"0.01 MPa\"");
  EXPECT_GT(strong, 50.0);
  EXPECT_LT(strong, 900.0);
  EXPECT_TRUE(weak < 0.0 || weak > strong) << weak;  // later, or after the run
}

// A two-dimensional arc under pressure has the same tension everywhere: it swells round where it is soft, and then runs
// away. An axisymmetric cell has grown a finger of three times that aspect by the time.
TEST(YeastControls, PlaneStrainMakesNoFinger) {
  const Overrides plane{{"axisymmetric", "false"}, {"depth", "\"1 um\""}};
  const auto flat = shape_of("case-2.toml", "\"100 s\"", plane);
  EXPECT_LT(flat.aspect, 1.15);
}

}  // namespace
}  // namespace shmoo::coupling
