#pragma once
// The laws of the case studies, for the quick and the long runs of them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "memory_sink.hpp"

namespace shmoo::test {

inline double total(const MemorySink& sink, const std::string& species, std::size_t time) {
  const auto& n = sink.at(species, time);
  return std::accumulate(n.begin(), n.end(), 0.0);
}

inline std::size_t times(const Laboratory& lab) { return lab.experiment->layout().times.size(); }

// Sums of species that nothing may change.
inline void expect_kept(const Laboratory& lab, const MemorySink& sink, const std::vector<std::string>& species,
                        double molecules) {
  for (std::size_t time = 0; time < times(lab); ++time) {
    double sum = 0.0;
    for (const auto& one : species) sum += total(sink, one, time);
    ASSERT_EQ(sum, molecules) << species.front() << " at record " << time;
  }
}

inline void expect_min_kept(const Laboratory& lab, const MemorySink& sink) {
  expect_kept(lab, sink, {"D_ADP", "D_ATP", "d", "de"}, 4000.0);
  expect_kept(lab, sink, {"E", "de"}, 1400.0);
}

inline void expect_polarisome_kept(const Laboratory& lab, const MemorySink& sink) {
  expect_kept(lab, sink, {"Bni1_c", "Bni1_m"}, 1000.0);
  expect_kept(lab, sink, {"Actin_c", "Actin_m"}, 40.0);
  expect_kept(lab, sink, {"Spa2_c", "Spa2_m"}, 5000.0);
}

}  // namespace shmoo::test
