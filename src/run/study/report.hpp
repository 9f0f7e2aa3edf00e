#pragma once
// A page from the summaries of many studies: per regime, which method to pick for which accuracy, and what it costs.
#include <filesystem>
#include <string>

#include "run/study/summary.hpp"

namespace shmoo::run::study {

std::string printed(const Summary& summary);  // for the terminal

// Reads every summary (*.toml) in `folder`; pictures beside them are shown. base::InputError where there is none.
std::string report(const std::filesystem::path& folder, const std::filesystem::path& page);

}  // namespace shmoo::run::study
