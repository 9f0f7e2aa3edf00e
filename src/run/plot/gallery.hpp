#pragma once
// The pictures that can be made of a result.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "run/result_file.hpp"

namespace shmoo::run {

struct Picture {
  std::string name;  // of its file
  std::string of;    // the field or observable
  std::function<void(const std::filesystem::path&)> draw;
};

struct GalleryChoice {
  std::string field{}, observable{};  // both empty: everything but places and volumes
  std::vector<std::size_t> times{};   // records; not empty
  bool arrows = false, around = false;
};

// The pictures refer to `result`. base::InputError for names that it does not hold.
std::vector<Picture> gallery(const ResultFile& result, const GalleryChoice& choice);

}  // namespace shmoo::run
