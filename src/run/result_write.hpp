#pragma once
// Writes and restores result files. The layout is told in docs/results.md.
#include <hdf5.h>

#include <filesystem>
#include <string>

#include "run/description.hpp"
#include "run/results.hpp"

namespace shmoo::run {

struct Status {
  std::string word;     // "running", "done", "part" (only one was asked for), "interrupted", "failed"
  std::string message;  // why it failed; else empty
};

// The whole file, replaced in one stroke. base::RunError where that cannot be done; then the old file stays.
void write_result(const std::filesystem::path& path, const Description& description, const Results& results,
                  const Status& status, const Provenance& provenance);

// Parts of the file.
void write_statistics(hid_t file, const Description& description, const Results& results);
void write_checkpoint(hid_t file, const Results& results);

// Takes over the finished realisations of `path`, which must stem from the same model text, seed and records and must
// not hold more realisations than `results`; else base::InputError.
void restore_result(const std::filesystem::path& path, const Description& description, Results& results);

// What a glance at an existing file says.
struct Glance {
  std::string status, title;
  std::size_t realisations = 0, done = 0;
};
Glance glance_at(const std::filesystem::path& path);  // base::RunError where it is no result of this program

}  // namespace shmoo::run
