// The same bits for any number of threads and any order of realisations, on the whole program's experiment.
#include <gtest/gtest.h>
#include <omp.h>

#include "memory_sink.hpp"

namespace {

using namespace shmoo;

test::Laboratory small_yeast(const std::string& sampler) {
  return test::laboratory(
      "yeast-gradient/published-4um.toml",
      {{"run.until", "\"10 ms\""}, {"run.record_every", "\"5 ms\""}, {"numerics.sampler", "\"" + sampler + "\""}});
}

class SameBits : public testing::TestWithParam<std::string> {};

TEST_P(SameBits, ForOneTwoAndFiveThreadsAndAnyOrderOfRealisations) {
  const int before = omp_get_max_threads();
  std::vector<std::map<std::string, std::map<std::size_t, std::vector<double>>>> shared, alone;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    const auto lab = small_yeast(GetParam());
    shared.push_back(lab.shared.fields());
    if (threads == 2) lab.realise(7);  // what ran before must not matter
    alone.push_back(lab.realise(3).fields());
  }
  omp_set_num_threads(before);
  for (std::size_t k = 1; k < shared.size(); ++k) {
    EXPECT_EQ(shared[k], shared[0]);
    EXPECT_EQ(alone[k], alone[0]);
  }
}

TEST_P(SameBits, RealisationsDiffer) {
  const auto lab = small_yeast(GetParam());
  EXPECT_NE(lab.realise(0).at("L", 2), lab.realise(1).at("L", 2));
}

INSTANTIATE_TEST_SUITE_P(Samplers, SameBits, testing::Values("composition_rejection", "split"));

}  // namespace
