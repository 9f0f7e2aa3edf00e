#pragma once
// One plain file per finished run, from which a study that was stopped goes on.
#include <filesystem>
#include <optional>

#include "run/study/point.hpp"

namespace shmoo::run::study {

// Whole or not at all. base::RunError where it cannot be written.
void write_point(const std::filesystem::path& path, const Task& task, const Point& point);

// None where there is no such file, or one of another task.
std::optional<Point> read_point(const std::filesystem::path& path, const Task& task);

// `text` becomes the file's contents in one stroke.
void write_whole(const std::filesystem::path& path, const std::string& text);

}  // namespace shmoo::run::study
