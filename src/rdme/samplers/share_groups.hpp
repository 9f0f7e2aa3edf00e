#pragma once
// Groups of voxels, each with random numbers of its own, shared out among threads.
#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <exception>

namespace shmoo::rdme {

// Neighbours by id that share a sequence of random numbers, in diffusion and in the reactions of a splitting step.
constexpr std::uint32_t voxels_per_sequence = 256;

// Calls work(begin, end, thread) for each group [begin, end) of voxels. Where several fail, the error is that of the
// first group, for any number of threads.
template <class Work>
void share_groups(std::uint32_t voxels, std::size_t threads, Work work) {
  const std::uint32_t groups = (voxels + voxels_per_sequence - 1) / voxels_per_sequence;
  std::exception_ptr error;
  std::uint32_t failed = groups;
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads)) if (threads > 1)
  for (std::uint32_t g = 0; g < groups; ++g) {
    const std::uint32_t begin = g * voxels_per_sequence;
    try {
      work(begin, std::min(voxels, begin + voxels_per_sequence), static_cast<std::size_t>(omp_get_thread_num()));
    } catch (...) {
#pragma omp critical(shmoo_share_groups)
      if (g < failed) {
        failed = g;
        error = std::current_exception();
      }
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace shmoo::rdme
