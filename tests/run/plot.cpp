// Pictures are made for every kind of result; what cannot be drawn is refused. How they look is for eyes.
#include "run/plot/plot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "fake_experiment.hpp"
#include "run/ensemble.hpp"
#include "run/plot/gnuplot.hpp"
#include "run/plot/raster.hpp"
#include "scratch.hpp"

namespace shmoo::run {
namespace {

bool is_png(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head(8, '\0');
  in.read(head.data(), 8);
  return head == "\x89PNG\r\n\x1a\n" && std::filesystem::file_size(path) > 2000;
}

TEST(Plot, EveryDimensionGivesPictures) {
  for (const int dimension : {1, 2, 3}) {
    for (const std::uint32_t n : {1u, 5u}) {
      const Scratch scratch;
      FakeExperiment fake(dimension, 6, 3);
      run_ensemble(fake, {.output = scratch / "r.h5", .realisations = n});
      const ResultFile result(scratch / "r.h5");
      plot_field(result, result.field("L"), 2, {}, scratch / "L.png");
      plot_field(result, result.field("velocity"), 1, {.arrows = true}, scratch / "v.png");
      plot_observable(result, result.observable("total_L"), 2, scratch / "c.png");
      plot_observable(result, result.observable("row_of_L"), 2, scratch / "p.png");
      for (const auto* name : {"L.png", "v.png", "c.png", "p.png"})
        EXPECT_TRUE(is_png(scratch / name)) << name << dimension;
      if (dimension != 2) continue;
      plot_around(result, result.field("L"), 2, scratch / "a.png");
      EXPECT_TRUE(is_png(scratch / "a.png"));
    }
  }
}

// [pixels] across, from the head of the file.
unsigned width(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::string head(24, '\0');
  in.read(head.data(), 24);
  unsigned pixels = 0;
  for (const std::size_t at : {16u, 17u, 18u, 19u}) pixels = 256 * pixels + static_cast<unsigned char>(head[at]);
  return pixels;
}

// With both halves a picture of the same height is half as wide.
TEST(Plot, ABodyOfRevolutionIsShownWhole) {
  const Scratch scratch;
  for (const bool turned : {false, true}) {
    FakeExperiment fake(2, 6, 3);
    fake.scene_.axisymmetric = turned;
    const auto file = scratch / (turned ? "turned.h5" : "flat.h5");
    run_ensemble(fake, {.output = file, .realisations = 2});
    const ResultFile result(file);
    EXPECT_EQ(result.axisymmetric, turned);
    plot_field(result, result.field("velocity"), 1, {}, scratch / (turned ? "turned.png" : "flat.png"));
  }
  EXPECT_LT(width(scratch / "turned.png"), 0.8 * width(scratch / "flat.png"));
}

TEST(Plot, TitlesCannotReachTheShellOrTheScript) {
  EXPECT_EQ(quoted("it's `x`\n'; system 'y"), "'it’s `x` ’; system ’y'");
  const Scratch scratch;
  FakeExperiment fake(2, 4, 2);
  const auto trap = (scratch / "trap").string();
  fake.scene_.title = "'\nsystem 'touch " + trap + "'\n`touch " + trap + "` $(touch " + trap + ") @x";
  run_ensemble(fake, {.output = scratch / "r.h5", .realisations = 2});
  const ResultFile result(scratch / "r.h5");
  plot_field(result, result.field("L"), 0, {}, scratch / "it's; $(touch x).png");
  EXPECT_TRUE(is_png(scratch / "it's; $(touch x).png"));
  EXPECT_FALSE(std::filesystem::exists(trap));
}

TEST(Plot, AMissingGnuplotIsNamedWithItsPackage) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  try {
    Gnuplot().draw("plot x", 100, 100, "x.png");
    ADD_FAILURE() << "no error";
  } catch (const base::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("install the package gnuplot-nox"), std::string::npos) << error.what();
  }
  setenv("PATH", path.c_str(), 1);
}

TEST(Plot, PixelsTakeTheNearestParticle) {
  const std::vector<double> points{0.5, 0.5, 1.5, 0.5};
  const auto pixels = nearest_particles(points, {0, 4, 0, 1}, 4, 1, 1.2);
  EXPECT_EQ(pixels, (std::vector<std::int32_t>{0, 1, 1, -1}));
  const auto bytes = coloured(pixels, {0.0, std::nan("")}, {0, 1}, {grey_of_others, grey_of_walls});
  ASSERT_EQ(bytes.size(), 12u);
  EXPECT_EQ(bytes.substr(0, 3), "\x44\x01\x54");
  EXPECT_EQ(bytes.substr(3, 3), "\xc9\xc4\xbc");
  EXPECT_EQ(bytes.substr(9, 3), "\xff\xff\xff");
}

TEST(Plot, UnitsAreReadable) {
  EXPECT_EQ(readable("m", 2e-4).unit, "µm");
  EXPECT_EQ(readable("m/s", 2.5e-4).unit, "µm/s");
  EXPECT_EQ(readable("molecules/m^3", 1e20).unit, "molecules/µm³");
  EXPECT_DOUBLE_EQ(readable("molecules/m^3", 1e20).factor, 1e-18);
  EXPECT_EQ(readable("molecules", 1.6e6).unit, "10⁶ molecules");
  EXPECT_EQ(readable("molecules", 500).unit, "molecules");
  EXPECT_EQ(readable("kg/m^3", 1000).unit, "kg/m^3");
  EXPECT_EQ(time_text(0.02), "t = 20 ms");
}

}  // namespace
}  // namespace shmoo::run
