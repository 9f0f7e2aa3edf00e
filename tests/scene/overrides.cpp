#include <gtest/gtest.h>

#include "scene/document.hpp"
#include "scene/read.hpp"

namespace shmoo::scene {
namespace {

const std::string sketch_file = SHMOO_SOURCE_DIR "/tests/data/yeast-sketch.toml";

Scene with(const Overrides& overrides) { return read_scene(sketch_file, overrides); }

std::string message(const Overrides& overrides) {
  try {
    with(overrides);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Overrides, ReplaceAndAddValues) {
  const Scene scene = with({{"run.seed", "7"},
                            {"region.0.diameter", "\"4 um\""},
                            {"domain.spacing", "2 um"},
                            {"numerics.kernel", "lucy"},
                            {"domain.boundary.y_max", "{ type = \"wall\", velocity = [\"1 um/s\", \"0 m/s\"] }"},
                            {"species.L.method", "deterministic"},
                            {"reaction.0.name", "binding"}});
  EXPECT_EQ(scene.run.seed, 7u);
  EXPECT_DOUBLE_EQ(std::get<BallShape>(scene.regions[0].shape->form).radius, 2e-6);
  EXPECT_DOUBLE_EQ(scene.domain.spacing, 2e-6);
  EXPECT_EQ(scene.numerics.kernel, Kernel::lucy);
  EXPECT_DOUBLE_EQ(scene.domain.sides[1][1].velocity[0], 1e-6);
  EXPECT_EQ(scene.domain.sides[1][0].velocity[0], 0);
  EXPECT_EQ(scene.species[0].method, SpeciesMethod::deterministic);
  EXPECT_EQ(scene.reactions[1].name, "binding (backward)");
}

TEST(Overrides, ReachEntriesByName) {
  const std::string text =
      read_bytes(sketch_file) + "\n[[observable]]\nname = \"bound\"\ntype = \"count\"\nspecies = \"RL\"\n";
  const Scene scene = read_scene_text(text, "model.toml", {{"observable.bound.species", "R"}});
  EXPECT_EQ(scene.observables[0].species, 1);
  EXPECT_EQ(read_scene_text(text, "model.toml", {{"materials.\"medium\".density", "998 kg/m^3"}}).materials[1].density,
            998);
}

TEST(Overrides, TheResultingTextSaysTheSame) {
  const Scene scene = with({{"run.seed", "7"},
                            {"inflow.1.velocity", "[\"0.3 mm/s\", \"-0.1 um/s\"]"},
                            {"domain.jitter", "0.123456789012345678"}});
  const Scene again = read_scene_text(scene.text, "again.toml");
  EXPECT_EQ(again.run.seed, 7u);
  EXPECT_EQ(again.inflows[1].velocity, scene.inflows[1].velocity);
  EXPECT_EQ(again.domain.jitter, scene.domain.jitter);
  EXPECT_EQ(again.regions.size(), scene.regions.size());
  EXPECT_EQ(again.reactions[0].rate_constant, scene.reactions[0].rate_constant);
}

TEST(Overrides, WithoutThemTheTextIsTheFile) { EXPECT_EQ(with({}).text, read_bytes(sketch_file)); }

TEST(Overrides, WrongOnesAreRefused) {
  EXPECT_EQ(message({{"run.sed", "7"}}),
            "--set run.sed=7: error: run.sed: unknown key; did you mean 'seed'? Allowed here: until, record_every, "
            "record_at, "
            "realisations, seed, record, quantiles");
  EXPECT_EQ(message({{"run.seed", "seven"}}),
            "--set run.seed=seven: error: run.seed: got \"seven\"; expected a whole number (>= 0)");
  EXPECT_EQ(message({{"region.2.diameter", "1 um"}}),
            "--set region.2.diameter=1 um: error: there is no entry 2; the list has 2, numbered from 0");
  EXPECT_EQ(
      message({{"region.cell.diameter", "1 um"}}),
      "--set region.cell.diameter=1 um: error: \"cell\" is neither the number nor the name of an entry of the list");
  EXPECT_EQ(message({{"run.seed.x", "1"}}),
            "--set run.seed.x=1: error: \"x\" cannot be set: what holds it is neither a table nor a list");
  EXPECT_EQ(message({{"run..seed", "1"}}),
            "--set run..seed=1: error: the path has an empty part; write it like run.seed=7");
  EXPECT_EQ(message({{"domain.size", "[\"1 um\","}}).substr(0, 63),
            "--set domain.size=[\"1 um\",: error: the value is not TOML: Error");
  EXPECT_EQ(message({{"materials.medum.density", "1 kg/m^3"}, {"flow.body_force", "[1, 2]"}}).find("accepted"),
            std::string::npos);
}

TEST(Overrides, AllMistakesComeAtOnce) {
  const std::string text = message({{"run.sed", "7"}, {"run.until", "1"}, {"domain.spacing", "1 s"}});
  EXPECT_NE(text.find("--set run.sed=7"), std::string::npos);
  EXPECT_NE(text.find("--set run.until=1: error: run.until: got 1 without a unit"), std::string::npos);
  EXPECT_NE(text.find("--set domain.spacing=1 s"), std::string::npos);
}

}  // namespace
}  // namespace shmoo::scene
