#pragma once
// Values as TOML that reads back to the same bits.
#include <string>
#include <vector>

namespace shmoo::run::study {

std::string toml_text(double value);
std::string toml_text(const std::string& text);
std::string toml_text(const std::vector<double>& values);

}  // namespace shmoo::run::study
