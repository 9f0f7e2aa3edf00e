#include "scene/document.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.hpp"
#include "scene/network.hpp"
#include "scene/overrides.hpp"

namespace shmoo::scene {
namespace {

constexpr std::uintmax_t largest_file = 16 * 1024 * 1024;  // bytes
constexpr int longest_key_path = 64;                       // parts of a dotted key

[[noreturn]] void refuse(const base::Location& where, const std::string& message) {
  throw base::InputError(std::vector<base::Diagnostic>{{where, message}});
}

// Tables nested by dotted keys have no limit in TOML, but each level costs stack when they are destroyed.
void guard_key_paths(const std::string& text, const std::string& file) {
  int line = 1, column = 0, dots = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char character = text[i];
    ++column;
    if (character == '\n') {
      ++line;
      column = dots = 0;
      quote = 0;
    } else if (quote) {
      if (character == '\\' && quote == '"')
        ++i, ++column;
      else if (character == quote)
        quote = 0;
    } else if (character == '"' || character == '\'') {
      quote = character;
    } else if (character == ',' || character == '=' || character == '#') {
      dots = 0;
    } else if (character == '.' && ++dots >= longest_key_path) {
      refuse({file, line, column}, fmt::format("a key of more than {} parts is not allowed", longest_key_path));
    }
  }
}

}  // namespace

std::string read_bytes(const std::string& file, std::string_view kind) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) refuse({file, 0, 0}, fmt::format("there is no such file; give the path of a {} file", kind));
  if (std::filesystem::is_directory(status)) refuse({file, 0, 0}, fmt::format("this is a directory; give the path of a {} file", kind));
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse({file, 0, 0}, "the file cannot be read; check its permissions");
  std::string bytes;
  std::vector<char> block(1 << 16);
  while (stream.read(block.data(), static_cast<std::streamsize>(block.size())) || stream.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > largest_file) refuse({file, 0, 0}, fmt::format("the file is larger than 16 MiB, which no {} file is", kind));
  }
  return bytes;
}

Document parse_document(const std::string& text, const std::string& file, const Overrides& overrides,
                        std::string_view needs) {
  if (text.size() > largest_file) refuse({file, 0, 0}, "the file is larger than 16 MiB, which no model file is");
  guard_key_paths(text, file);
  Document document;
  try {
    document.root = toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    refuse({file, static_cast<int>(begin.line), static_cast<int>(begin.column)},
           fmt::format("this is not TOML: {}", error.description()));
  }
  if (document.root.empty() && overrides.empty()) refuse({file, 0, 0}, fmt::format("the file is empty; {}", needs));
  const bool joined = resolve_network(document.root, file);
  if (overrides.empty() && !joined) {
    document.text = text;
    return document;
  }
  apply_overrides(document.root, overrides);
  std::ostringstream stream;
  stream << toml::toml_formatter(document.root) << '\n';
  document.text = stream.str();
  return document;
}

}  // namespace shmoo::scene
