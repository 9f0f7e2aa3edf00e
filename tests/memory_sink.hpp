#pragma once
// Shipped models in memory.
#include <string>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::test {

using coupling::Laboratory;
using coupling::MemorySink;

inline Laboratory laboratory(const std::string& model, const scene::Overrides& overrides = {}) {
  return Laboratory(scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/" + model, overrides));
}

}  // namespace shmoo::test
