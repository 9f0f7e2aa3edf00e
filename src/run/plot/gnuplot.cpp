#include "run/plot/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace shmoo::run {
namespace {

// Runs gnuplot in `folder` on script.gp; its complaints go to a file. Returns its exit status, 127 where there is none.
int call_gnuplot(const std::filesystem::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "complaints.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  std::string name = "gnuplot", argument = "script.gp";
  std::array<char*, 3> words{name.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return 127;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

void Gnuplot::table(const std::string& name, const std::vector<std::vector<double>>& columns) const {
  std::string text;
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    for (const auto& column : columns) {
      if (std::isfinite(column[row]))
        fmt::format_to(std::back_inserter(text), "{:.10g} ", column[row]);
      else
        text += "NaN ";
    }
    text += '\n';
  }
  bytes(name, text);
}

void Gnuplot::bytes(const std::string& name, const std::string& data) const {
  std::ofstream out(folder_.path() / name, std::ios::binary);
  out << data;
  out.close();
  if (!out) throw base::RunError(fmt::format("cannot write {}", (folder_.path() / name).string()));
}

void Gnuplot::draw(const std::string& script, int width, int height, const std::filesystem::path& png) const {
  bytes("script.gp",
        fmt::format("set encoding utf8\nset terminal pngcairo size {},{} font 'DejaVu Sans,11' noenhanced\n"
                    "set output 'picture.png'\n{}\nset output\n",
                    width, height, script));
  const int status = call_gnuplot(folder_.path());
  if (status == 127)
    throw base::RunError("plots need gnuplot, which is not installed; install the package gnuplot-nox");
  const auto picture = folder_.path() / "picture.png";
  std::error_code error;
  if (status != 0 || !std::filesystem::exists(picture) || std::filesystem::file_size(picture, error) == 0) {
    throw base::RunError(
        fmt::format("gnuplot could not draw {}: {}", png.string(), contents(folder_.path() / "complaints.txt")));
  }
  std::filesystem::copy_file(picture, png, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw base::RunError(fmt::format("cannot write {}: {}", png.string(), error.message()));
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 32)
      out += ' ';
    else
      out += c == '\'' ? std::string("’") : std::string(1, c);
  }
  return out + "'";
}

}  // namespace shmoo::run
