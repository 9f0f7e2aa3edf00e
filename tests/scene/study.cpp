// Study files: what a good one says, and one message for every mistake of a bad one.
#include "scene/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/exact_solutions.hpp"
#include "json_schema_validator.hpp"
#include "scene/document.hpp"

namespace shmoo::scene {
namespace {

const std::filesystem::path models = SHMOO_SOURCE_DIR "/models";
const std::string here = SHMOO_SOURCE_DIR "/models/validation/diffusion-1d/test.toml";

const std::string head = R"(title = "T"
name = "t"
model = "model.toml"
[[method]]
name = "exact"
[[method]]
name = "split"
mean_of = "exact"
[[level]]
name = "1"
[[level]]
name = "2"
set = { "domain.spacing" = "0.03125 m", "region.0.upper" = ["0.01 m"] }
)";
const std::string quantity = "[[quantity]]\nname = \"q\"\nfield = \"C\"\n";
const std::string reference = "reference = { value = 1.0 }\n";

std::string messages(const std::string& text) {
  try {
    read_study_text(text, here);
  } catch (const base::InputError& error) {
    std::string all = error.what();
    for (auto at = all.find(here); at != std::string::npos; at = all.find(here)) all.replace(at, here.size(), "S");
    return all;
  }
  return "accepted";
}

TEST(Study, SaysWhatItSays) {
  const auto study = read_study_text(
      head + quantity +
          "time = \"1 s\"\nscale = \"boundary.0.value\"\npublished = { split = [1e-3, 0] }\nshape = \"box\"\n"
          "lower = [\"0 m\"]\nupper = [\"1 m\"]\n[quantity.reference]\nformula = \"slab_diffusion\"\nparameters = { "
          "length = \"1 m\", diffusivity = \"species.C.diffusivity\", concentration = \"1 nM\" }\n",
      here);
  ASSERT_EQ(study.methods.size(), 2u);
  EXPECT_EQ(study.methods[1].mean_of, 0u);
  ASSERT_EQ(study.levels[1].set.size(), 2u);
  EXPECT_EQ(study.levels[1].set[0].first, "domain.spacing");
  EXPECT_EQ(study.quantities[0].scale->path, "boundary.0.value");
  EXPECT_EQ(study.quantities[0].reference.parameters[1].path, "species.C.diffusivity");
  EXPECT_NEAR(study.quantities[0].reference.parameters[2].value, 6.02214076e17, 1e9);
  EXPECT_TRUE(study.quantities[0].region);
  EXPECT_EQ(study.resolution, "domain.spacing");
}

struct Mistake {
  std::string text, message;
};

class BadStudy : public testing::TestWithParam<Mistake> {};

TEST_P(BadStudy, IsRefusedWithItsMessage) { EXPECT_EQ(messages(GetParam().text), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    All, BadStudy,
    testing::Values(
        Mistake{"",
                "S: error: the file is empty; a study needs at least title, name, model, [[method]], [[level]] and "
                "[[quantity]]"},
        Mistake{
            head + quantity + reference + "colour = 1\n",
            "S:18:1: error: quantity.0.colour: unknown key; allowed here: name, field, observable, component, time, "
            "average, amplitude, period, harmonic, harmonic_period, reference, norm, scale, relative, published, "
            "published_norm, shape, "
            "and the keys of a shape"},
        Mistake{head + "[[quantity]]\nname = \"q\"\nfield = \"c\"\n" + reference,
                "S:16:9: error: quantity.0.field: the model has no field \"c\"; it has: C"},
        Mistake{
            head + "[[quantity]]\nname = \"q\"\nobservable = \"profil\"\n" + reference,
            "S:16:14: error: quantity.0.observable: the model has no observable \"profil\"; did you mean 'profile'? "
            "It has: profile"},
        Mistake{head + quantity + "reference = { formula = \"slab_difusion\" }\n",
                "S:17:25: error: quantity.0.reference.formula: there is no exact solution \"slab_difusion\"; did you "
                "mean 'slab_diffusion'? Known: slab_diffusion, plate_diffusion, channel_flow, circular_couette, "
                "inclined_couette, taylor_green_speed, "
                "taylor_green_energy, lame_ring_strain, lame_ring_stress, lame_sphere_strain, lame_sphere_stress"},
        Mistake{
            head + quantity +
                "reference = { formula = \"plate_diffusion\", parameters = { length = \"1 s\", concentration = "
                "\"boundary.0.value\" } }\n",
            "S:17:68: error: quantity.0.reference.parameters.length: expected a length [m], such as \"1 um\", or the "
            "path of such a key of the model"},
        Mistake{head + quantity + "reference = { value = 1.0, finest = true }\n",
                "S:17:13: error: quantity.0.reference: 2 of 'formula', 'table', 'finest', 'method' and 'value' are "
                "given; give one"},
        Mistake{head + quantity + "reference = { table = \"none.csv\" }\n",
                "S:17:23: error: quantity.0.reference.table: there is no file \"none.csv\" beside the study"},
        Mistake{head + quantity + reference + "published = { split = [1.0] }\n",
                "S:18:23: error: quantity.0.published.split: 1 figures for 2 levels; give one per level, 0 where there "
                "is none"},
        Mistake{head + "[[method]]\nname = \"split\"\nlevels = [\"3\"]\n" + quantity + reference,
                "S:15:8: error: method.2.name: \"split\" is there twice; names must differ\nS:16:11: error: "
                "method.2.levels: there is no level \"3\"; levels: 1, 2"},
        Mistake{head + quantity + reference + "average = [\"2 s\", \"1 s\"]\n",
                "S:18:11: error: quantity.0.average: is taken of an observable only"}));

TEST(Study, EveryShippedOneIsReadAndFitsTheSchemaForEditors) {
  const JsonSchemaValidator validator(nlohmann::json::parse(study_json_schema()));
  int studies = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    if (!entry.path().filename().string().starts_with("study")) continue;
    ++studies;
    EXPECT_NO_THROW(read_study(entry.path())) << entry.path();
    std::ostringstream json;
    json << toml::json_formatter(toml::parse(read_bytes(entry.path())));
    EXPECT_TRUE(validator.valid(nlohmann::json::parse(json.str()))) << entry.path();
  }
  EXPECT_GE(studies, 1);
}

TEST(Study, FindsNumbersInAModel) {
  const std::string text = "a = 3\n[d]\nsize = [\"1 um\", \"2 um\"]\n[[b]]\nname = \"hot\"\nv = \"1 nM\"\n";
  EXPECT_EQ(number_in_model(text, "a").value, 3.0);
  EXPECT_DOUBLE_EQ(number_in_model(text, "d.size.1").value, 2e-6);
  EXPECT_EQ(number_in_model(text, "b.hot.v").dimension, base::dimensions::concentration);
  EXPECT_THROW(number_in_model(text, "d.siz"), std::runtime_error);
  EXPECT_THROW(number_in_model(text, "b.0.name.x"), std::runtime_error);
}

// With SHMOO_UPDATE_DOCS set in the environment the file is brought up to date instead.
TEST(Study, ReferenceInTheDocumentationIsUpToDate) {
  const std::string file = SHMOO_SOURCE_DIR "/docs/study-file.md";
  const std::string text = read_bytes(file), begin = "<!-- reference: begin -->\n", end = "<!-- reference: end -->\n";
  const auto from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::string wanted = text.substr(0, from + begin.size()) + study_key_reference() + text.substr(to);
  if (std::getenv("SHMOO_UPDATE_DOCS"))
    std::ofstream(file, std::ios::binary) << wanted;
  else
    EXPECT_TRUE(text == wanted) << "run this test with SHMOO_UPDATE_DOCS=1 to bring docs/study-file.md up to date";
}

// The formulas solve what they say they solve: central differences of the equation, and the sides.
TEST(ExactSolutions, SolveTheirEquations) {
  const double h = 1e-3;
  const auto value = [](const char* name, std::vector<double> p, base::ExactSolution::Point x, double t) {
    return base::find_exact_solution(name)->value(x, t, p);
  };
  const std::vector<double> slab{2.0, 0.3, 5.0}, plate{2.0, 5.0}, channel{2.0, 0.7, 0.3, 1.5};
  const auto c = [&](double x, double t) { return value("slab_diffusion", slab, {x, 0, 0}, t); };
  const auto s = [&](double x, double y) { return value("plate_diffusion", plate, {x, y, 0}, 0); };
  const auto u = [&](double y, double t) { return value("channel_flow", channel, {0, y, 0}, t); };
  EXPECT_NEAR((c(0.7, 1 + h) - c(0.7, 1 - h)) / (2 * h),
              0.3 * (c(0.7 + h, 1) - 2 * c(0.7, 1) + c(0.7 - h, 1)) / (h * h), 1e-5);
  EXPECT_NEAR(c(0, 1), 5.0, 1e-9);
  EXPECT_NEAR(c(2, 1), 0.0, 1e-9);
  EXPECT_NEAR((s(0.7 + h, 1.1) + s(0.7 - h, 1.1) + s(0.7, 1.1 + h) + s(0.7, 1.1 - h) - 4 * s(0.7, 1.1)) / (h * h), 0.0,
              1e-5);
  EXPECT_NEAR(s(1.0, 1.999), 5.0, 0.01);
  EXPECT_NEAR((u(0.7, 1 + h) - u(0.7, 1 - h)) / (2 * h),
              0.7 + 0.2 * (u(0.7 + h, 1) - 2 * u(0.7, 1) + u(0.7 - h, 1)) / (h * h), 1e-5);
  EXPECT_NEAR(u(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(u(0.5, 1e-9), 0.0, 1e-6);
  const std::vector<double> vortex{2.0, 3.0, 0.1, 1.5, 0.5};
  const double rate = 2 * std::pow(2 * std::numbers::pi / 3.0, 2) * 0.1 / 1.5;
  EXPECT_NEAR(value("taylor_green_speed", vortex, {}, 1.7), 2.0 * std::exp(-1.7 * rate), 1e-12);
  // rho/2 <u^2 + v^2> = rho U^2/4 over 3 x 3 x 0.5 m^3
  EXPECT_NEAR(value("taylor_green_energy", vortex, {}, 0.0), 0.25 * 1.5 * 4.0 * 4.5, 1e-12);
}

}  // namespace
}  // namespace shmoo::scene
