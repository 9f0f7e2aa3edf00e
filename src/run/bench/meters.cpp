#include <malloc.h>

#include <ctime>

#include "run/bench/workload.hpp"

namespace shmoo::run::bench {

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double allocated_bytes() {
  const auto info = mallinfo2();
  return double(info.uordblks + info.hblkhd);
}

}  // namespace shmoo::run::bench
