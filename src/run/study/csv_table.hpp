#pragma once
// Reference tables: CSV with a head, lines beginning with # being remarks.
#include <string>
#include <utility>
#include <vector>

namespace shmoo::run::study {

// The first column and the named one (the second where the name is empty), in ascending order of the first.
// base::InputError where the file is no such table.
std::pair<std::vector<double>, std::vector<double>> read_columns(const std::string& file, const std::string& column);

}  // namespace shmoo::run::study
