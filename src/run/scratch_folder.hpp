#pragma once
// A folder for files of the moment, removed with all that is in it.
#include <filesystem>
#include <string>

namespace shmoo::run {

class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name);  // base::RunError where none can be made
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace shmoo::run
