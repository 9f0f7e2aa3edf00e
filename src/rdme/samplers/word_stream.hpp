#pragma once
// Random words of one address in the order in which they are taken, made many at a time.
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "base/random.hpp"

namespace shmoo::rdme {

class WordStream {
 public:
  static constexpr std::size_t most = 1024;  // at one take

  void open(const base::RandomSequence& random) {
    random_ = random;
    at_ = ready_ = 0;
  }
  base::RandomSequence& sequence() { return random_; }  // for numbers that take words by themselves

  std::span<const std::uint32_t> take(std::size_t count) {  // valid until the next take
    if (ready_ - at_ < count) refill(count);
    at_ += count;
    return {words_ + at_ - count, count};
  }

 private:
  static constexpr std::size_t batch = 256;

  void refill(std::size_t count) {
    std::copy(words_ + at_, words_ + ready_, words_);
    ready_ -= std::exchange(at_, 0);
    const std::size_t more = (count - ready_ + batch - 1) / batch * batch;
    random_.fill(words_ + ready_, more / 4);
    ready_ += more;
  }

  base::RandomSequence random_{{}, base::Stream::test};
  std::size_t at_ = 0, ready_ = 0;
  alignas(64) std::uint32_t words_[most + batch + 16];  // vectors may be read beyond what is taken
};

}  // namespace shmoo::rdme
