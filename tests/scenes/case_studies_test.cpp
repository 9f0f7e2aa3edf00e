// What the case studies conserve, in runs of demo size. Their other laws take minutes: long/case_studies_test.cpp.
#include "case_studies.hpp"

namespace {

using namespace shmoo::test;

TEST(CaseStudies, MinProteinsAreKept) {
  const auto lab = laboratory("minde/model.toml", {{"run.until", "\"0.2 s\""}, {"run.record_every", "\"0.1 s\""}});
  const auto sink = lab.realise(0);
  expect_min_kept(lab, sink);
  EXPECT_GT(total(sink, "d", 2), 0.0);
}

TEST(CaseStudies, ThePromoterIsFreeOrOccupied) {
  const auto lab = laboratory(
      "hes1/model.toml", {{"domain.spacing", "\"3 um\""}, {"run.until", "\"2 h\""}, {"run.record_every", "\"2 min\""}});
  const auto sink = lab.realise(0);
  expect_kept(lab, sink, {"G_free", "G_occupied"}, 1.0);
  EXPECT_GT(total(sink, "P", times(lab) - 1), 0.0);
}

TEST(CaseStudies, ThePolarisomeIsKept) {
  const auto lab = laboratory(
      "yeast-polarization/model.toml",
      {{"domain.spacing", "\"0.6283185307179586 um\""}, {"run.until", "\"10 s\""}, {"run.record_every", "\"5 s\""}});
  expect_polarisome_kept(lab, lab.realise(0));
}

}  // namespace
