#pragma once
// Joins parts of one ensemble, run wherever, into the result that one run would have given.
#include <filesystem>
#include <string>
#include <vector>

#include "run/command_line.hpp"
#include "run/results.hpp"

namespace shmoo::run {

struct MergeEnd {
  std::size_t done = 0, wanted = 0;  // realisations
};

// The parts stem from the same model text and seed, and no realisation is in two of them; else base::InputError, and
// nothing is written. All but /provenance is the same to the bit as in one run.
MergeEnd merge_results(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& output,
                       const Workshop& workshop, const std::string& command);

}  // namespace shmoo::run
