#pragma once
// A run as a process of its own: its crash, its hunger for time and its memory stay with it.
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shmoo::run::study {

struct Ending {
  std::string failure{};                                 // "" where it ended well
  double cpu_seconds = 0, wall_seconds = 0, memory = 0;  // memory: largest resident size [bytes]
};

class Child {
 public:
  // Starts `words` with at most `cpu_limit` seconds of CPU time; what it prints goes to `log`. It dies with its parent.
  Child(const std::vector<std::string>& words, std::filesystem::path log, double cpu_limit);
  ~Child();  // ends it if it still runs
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;

  std::optional<Ending> poll();  // none while it runs; ends it where it waits far beyond its limit

 private:
  Ending ending(int status) const;

  pid_t id_ = -1;
  std::filesystem::path log_;
  double cpu_limit_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace shmoo::run::study
