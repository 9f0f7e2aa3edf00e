#include "run/study/toml_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace shmoo::run::study {

std::string toml_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  const auto text = fmt::format("{}", value);  // the shortest that reads back to the same bits
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string toml_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < 32 || c == 127 ? ' ' : c;
  }
  return out + '"';
}

std::string toml_text(const std::vector<double>& values) {
  std::string out = "[";
  for (const double value : values) out += (out.size() > 1 ? ", " : "") + toml_text(value);
  return out + "]";
}

}  // namespace shmoo::run::study
