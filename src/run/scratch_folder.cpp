#include "run/scratch_folder.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "base/error.hpp"

namespace shmoo::run {

ScratchFolder::ScratchFolder(const std::string& name) {
  auto pattern = (std::filesystem::temp_directory_path() / (name + "-XXXXXX")).string();  // mkdtemp fills it in
  if (mkdtemp(pattern.data()) == nullptr)
    throw base::RunError(fmt::format("cannot make a temporary folder: {}", std::strerror(errno)));
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace shmoo::run
