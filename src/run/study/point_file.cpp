#include "run/study/point_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "run/study/toml_text.hpp"

namespace shmoo::run::study {
namespace {

struct Column {
  const char* name;
  std::vector<double> Sample::*values;
};
constexpr Column columns[] = {{"x", &Sample::x}, {"y", &Sample::y},         {"z", &Sample::z},
                              {"t", &Sample::t}, {"value", &Sample::value}, {"variance", &Sample::variance}};

struct Number {
  const char* name;
  double Point::*value;
};
constexpr Number numbers[] = {{"cpu_seconds", &Point::cpu_seconds},
                              {"wall_seconds", &Point::wall_seconds},
                              {"memory_bytes", &Point::memory},
                              {"cpu_seconds_per_realisation", &Point::cpu_per_realisation},
                              {"steps", &Point::steps},
                              {"events", &Point::events},
                              {"resolution", &Point::resolution}};

}  // namespace

void write_whole(const std::filesystem::path& path, const std::string& text) {
  auto part = path;
  part += ".part";
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (!out || error) throw base::RunError(fmt::format("cannot write {}", path.string()));
}

void write_point(const std::filesystem::path& path, const Task& task, const Point& point) {
  std::string text = fmt::format("# One run of a study; 'shmoo study' reads it again instead of repeating the run.\n");
  text += fmt::format("key = \"{}\"\ncommand = {}\nrevision = {}\nfailure = {}\n", task.key, toml_text(point.command),
                      toml_text(point.revision), toml_text(point.failure));
  for (const auto& [name, value] : numbers) text += fmt::format("{} = {}\n", name, toml_text(point.*value));
  for (const auto& sample : point.samples) {
    text += "\n[[sample]]\n";
    for (const auto& [name, values] : columns) text += fmt::format("{} = {}\n", name, toml_text(sample.*values));
  }
  write_whole(path, text);
}

std::optional<Point> read_point(const std::filesystem::path& path, const Task& task) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  toml::table root;
  try {
    root = toml::parse_file(path.string());
  } catch (const toml::parse_error&) {
    return std::nullopt;  // of another program, or damaged: the run is repeated
  }
  if (root["key"].value_or(std::string()) != task.key) return std::nullopt;
  Point point;
  point.command = root["command"].value_or(std::string());
  point.revision = root["revision"].value_or(std::string());
  point.failure = root["failure"].value_or(std::string());
  for (const auto& [name, value] : numbers) point.*value = root[name].value_or(unknown);
  if (const auto* samples = root["sample"].as_array())
    for (const auto& entry : *samples) {
      Sample sample;
      for (const auto& [name, values] : columns)
        if (const auto* list = entry.as_table()->get_as<toml::array>(name))
          for (const auto& value : *list) (sample.*values).push_back(value.value_or(unknown));
      point.samples.push_back(std::move(sample));
    }
  return point;
}

}  // namespace shmoo::run::study
