#pragma once
// Ctrl-C and its like: a polite request first, the end at once on the second.
#include <csignal>

namespace shmoo::run {

// While one lives, SIGINT and SIGTERM only set a flag; another one later than a second after the first ends the program
// as usual. (Batch systems and `timeout` send the same signal twice in one breath.)
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction old_interrupt_ {
  }, old_terminate_{};
};

bool interrupt_requested();

}  // namespace shmoo::run
