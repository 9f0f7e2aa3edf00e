#include <malloc.h>

#include "run/bench/workload.hpp"

namespace shmoo::run::bench {

double allocated_bytes() {
  const auto info = mallinfo2();
  return double(info.uordblks + info.hblkhd);
}

}  // namespace shmoo::run::bench
