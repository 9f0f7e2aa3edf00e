#include "rdme/samplers/wanderers.hpp"

#include <algorithm>

namespace shmoo::rdme {

std::int64_t Wanderers::move(std::uint32_t voxel, std::int64_t count, std::int64_t* rest) {
  std::int64_t made = 0;
  while (count > 0) {
    const auto some = static_cast<std::size_t>(std::min(count, std::int64_t{WordStream::most}));
    const std::size_t going = choose(some);
    rest[voxel] += static_cast<std::int64_t>(some - going);
    count -= static_cast<std::int64_t>(some);
    for (std::size_t k = 0; k < going; ++k) {
      std::uint32_t at = voxel;
      for (std::size_t j = 0; word_[k] < moves_.thresholds[j] || j == 0; ++j) {
        if (words_.take(1)[0] >= leave_[at * stride_] * scale_) continue;
        const std::uint32_t to = jumps_.target(at, words_);
        made += to != at ? 1 : 0;
        at = to;
      }
      ++rest[at];
    }
  }
  return made;
}

// Leaves the words of those that make a first move, and returns their number.
std::size_t Wanderers::choose(std::size_t count) {
  if (moves_.rare) {
    const auto going = base::binomial(words_.sequence(), static_cast<std::int64_t>(count), moves_.at_least.front());
    const auto words = words_.take(static_cast<std::size_t>(going));
    std::copy(words.begin(), words.end(), word_);
    return words.size();
  }
  std::size_t going = 0;
  for (const std::uint32_t word : words_.take(count)) {
    word_[going] = word;
    going += word < moves_.thresholds[0] ? 1U : 0U;
  }
  return going;
}

}  // namespace shmoo::rdme
