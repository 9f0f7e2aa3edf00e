#include "run/study/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/error.hpp"

namespace shmoo::run::study {
namespace {

constexpr double patience = 20.0;  // wall time per CPU time that is allowed, on a busy machine

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

// In the child: only calls that are safe between fork and exec.
[[noreturn]] void become(char* const* words, const char* log, rlim_t cpu_limit, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  const rlimit limit{cpu_limit, cpu_limit + 5};
  setrlimit(RLIMIT_CPU, &limit);
  const int in = open("/dev/null", O_RDONLY), out = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  setpgid(0, 0);  // Ctrl-C is for the study alone
  execv(words[0], words);
  _exit(127);
}

std::string last_line(const std::filesystem::path& log) {
  std::ifstream in(log);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && (last.empty() || line.find("error: ") != std::string::npos)) last = line;
  return last;
}

}  // namespace

Child::Child(const std::vector<std::string>& words, std::filesystem::path log, double cpu_limit)
    : log_(std::move(log)), cpu_limit_(cpu_limit) {
  std::vector<char*> pointers;
  for (const auto& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const auto parent = getpid();
  const auto limit = static_cast<rlim_t>(std::ceil(cpu_limit));
  id_ = fork();
  if (id_ < 0) throw base::RunError(fmt::format("cannot start a process: {}", std::strerror(errno)));
  if (id_ == 0) become(pointers.data(), log_.c_str(), limit, parent);
}

Child::Child(Child&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      log_(std::move(other.log_)),
      cpu_limit_(other.cpu_limit_),
      start_(other.start_) {}

Child::~Child() {
  if (id_ < 0) return;
  kill(id_, SIGKILL);
  while (waitpid(id_, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<Ending> Child::poll() {
  int status = 0;
  rusage used{};
  const auto ended = wait4(id_, &status, WNOHANG, &used);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  if (ended <= 0) {
    if (wall > patience * cpu_limit_ + 10.0) kill(id_, SIGXCPU);
    return std::nullopt;
  }
  id_ = -1;
  auto end = ending(status);
  end.cpu_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
  end.wall_seconds = wall;
  end.memory = 1024.0 * double(used.ru_maxrss);
  return end;
}

Ending Child::ending(int status) const {
  Ending end;
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    end.failure = WTERMSIG(status) == SIGXCPU
                      ? fmt::format("took more than the {:g} s of CPU time that the budget allows", cpu_limit_)
                      : "was killed (by a person, or for want of memory)";
  else if (WIFSIGNALED(status))
    end.failure = fmt::format("crashed: {}", strsignal(WTERMSIG(status)));
  else if (WEXITSTATUS(status) != 0)
    end.failure = fmt::format("exit code {}: {}", WEXITSTATUS(status), last_line(log_));
  return end;
}

}  // namespace shmoo::run::study
