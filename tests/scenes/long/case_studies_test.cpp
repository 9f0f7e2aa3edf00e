// The case studies at full size against what is known of them.
#include "../case_studies.hpp"

#include <algorithm>

namespace {

using namespace shmoo::test;

double observed(const MemorySink& sink, const std::string& name, std::size_t time) {
  return sink.observed(name, time)[0];
}

// The swings of one half's membrane MinD: mean time between upward passes through its middle, and its extremes, after
// the first 60 s.
struct Swings {
  double period = 0, largest = 0, smallest = 1e300;
  int number = 0;
};

Swings swings_of(const Laboratory& lab, const MemorySink& sink, const std::string& half) {
  std::vector<double> n;
  for (std::size_t k = 60; k < times(lab); ++k)
    n.push_back(observed(sink, "d_" + half, k) + observed(sink, "de_" + half, k));
  Swings swings;
  for (const double x : n) {
    swings.largest = std::max(swings.largest, x);
    swings.smallest = std::min(swings.smallest, x);
  }
  const double low = swings.smallest + 0.3 * (swings.largest - swings.smallest);
  const double high = swings.largest - 0.3 * (swings.largest - swings.smallest);
  bool below = false;
  double first = -1, last = -1;
  for (std::size_t k = 0; k < n.size(); ++k) {
    if (n[k] < low) below = true;
    if (n[k] > high && std::exchange(below, false)) {
      last = double(k);
      if (first < 0) first = last;
      ++swings.number;
    }
  }
  swings.period = swings.number > 1 ? (last - first) / (swings.number - 1) : 0.0;
  return swings;
}

// Huang, Meir, Wingreen 2003: about 40 s; 41.3 s by the deterministic equations on an axisymmetric grid, where one half
// of the side membrane holds between 514 and 1701 molecules.
TEST(CaseStudies, MinProteinsSwingBetweenThePoles) {
  const auto lab = laboratory("minde/model.toml");
  const auto sink = lab.realise(0);
  expect_min_kept(lab, sink);
  for (const char* half : {"left", "right"}) {
    const auto swings = swings_of(lab, sink, half);
    std::printf("minde, %s half: period %.1f s over %d swings, between %.0f and %.0f molecules\n", half, swings.period,
                swings.number, swings.smallest, swings.largest);
    EXPECT_GE(swings.number, 5);
    EXPECT_NEAR(swings.period, 41.0, 5.0);
  }
}

// At most as much as from a gene that is always free: 3.33 mRNA and 166.7 P on average.
TEST(CaseStudies, Hes1StaysWithinItsBounds) {
  const auto lab = laboratory("hes1/model.toml");
  double mRNA = 0.0, P = 0.0, records = 0.0;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const auto sink = lab.realise(k);
    expect_kept(lab, sink, {"G_free", "G_occupied"}, 1.0);
    for (std::size_t time = times(lab) / 4; time < times(lab); ++time, ++records) {
      mRNA += observed(sink, "mRNA_total", time);
      P += observed(sink, "P_total", time);
    }
  }
  std::printf("hes1: mean mRNA %.2f, mean P %.1f\n", mRNA / records, P / records);
  EXPECT_LT(mRNA / records, 0.002 / 6e-4);
  EXPECT_LT(P / records, 0.002 / 6e-4 * 0.015 / 3e-4);
  EXPECT_GT(P / records, 1.0);
}

// Most Spa2 gathers where the gradient of Cdc42 points to; spread evenly its standard deviation would be 7.3 um.
TEST(CaseStudies, ThePolarisomePointsToTheGradient) {
  const auto lab = laboratory("yeast-polarization/model.toml");
  const auto sink = lab.realise(0);
  expect_polarisome_kept(lab, sink);
  const auto& cap = sink.at("Spa2_m", times(lab) - 1);
  const double h = 25.132741228718345 / double(cap.size());
  double sum = 0.0, mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < cap.size(); ++i) {
    sum += cap[i];
    mean += cap[i] * (double(i) + 0.5) * h;
  }
  mean /= sum;
  for (std::size_t i = 0; i < cap.size(); ++i) variance += cap[i] / sum * std::pow((double(i) + 0.5) * h - mean, 2);
  std::printf(
      "yeast-polarization: %.0f Spa2 on the membrane, at %.2f um of 12.57, standard deviation %.2f um of 1.42\n", sum,
      mean, std::sqrt(variance));
  EXPECT_GT(sum, 2500.0);
  EXPECT_NEAR(mean, 12.57, 2.5);
  EXPECT_LT(std::sqrt(variance), 3.0);
}

// Extension [um] and least curvature (times 10 um) of a yeast projection at 4000 s.
struct Projection {
  double length = 0, flank = 0;
};

Projection projection(const std::string& model, shmoo::scene::Overrides more) {
  more.push_back({"run.record_every", "\"4000 s\""});
  const auto lab = laboratory("yeast-projection/" + model, more);
  const auto end = times(lab) - 1;
  const Projection found{1e6 * observed(lab.shared, "projection_length", end),
                         observed(lab.shared, "flank_curvature", end)};
  std::printf("yeast-projection/%s: %.3f um, flank %+.3f\n", model.c_str(), found.length, found.flank);
  EXPECT_LE(observed(lab.shared, "residual", end), 1e-8);
  EXPECT_EQ(observed(lab.shared, "outside", end), 0.0);
  return found;
}

// The papers pair a convex flank with the slow enzyme and a concave one with the fast: so it is where the enzyme is
// lost within two seconds and enters over a narrow tip, at six and at eight layers of wall.
TEST(CaseStudies, FlanksPartWhereTheEnzymeIsLostFast) {
  for (const char* spacing : {"\"0.41667 um\"", "\"0.3125 um\""}) {
    const shmoo::scene::Overrides fast{{"domain.spacing", spacing},
                                       {"reaction.0.forward", "\"0.5 1/s\""},
                                       {"mechanics.source.0.width", "\"0.5 um\""},
                                       {"materials.wall.growth.coefficient", "\"0.2 m^3/(mol MPa s)\""}};
    const auto one = projection("case-1.toml", fast), two = projection("case-2.toml", fast);
    EXPECT_GT(one.flank, 0.05);
    EXPECT_LT(two.flank, -0.05);
    EXPECT_GT(two.length, 2.0 * one.length);
  }
}

// Six against eight layers, and the tolerance of the steps against half of it.
TEST(CaseStudies, ProjectionsAreResolved) {
  for (const char* model : {"case-1.toml", "case-2.toml"}) {
    const auto six = projection(model, {}), eight = projection(model, {{"domain.spacing", "\"0.3125 um\""}}),
               half = projection(model, {{"mechanics.tolerance", "5e-4"}});
    EXPECT_NEAR(six.length, eight.length, 0.03 * eight.length);
    EXPECT_NEAR(six.length, half.length, 0.02 * half.length);
  }
}

}  // namespace
