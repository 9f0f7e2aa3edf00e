#pragma once
// The parts from which a study is built.
#include "scene/section.hpp"
#include "scene/study.hpp"

namespace shmoo::scene {

// The method that a key names; none, with a message, where there is no such method.
std::optional<std::size_t> method_index(const Section& section, std::string_view key, const Study& study);

void build_quantities(const Section& root, const Scene& scene, Study& study);

}  // namespace shmoo::scene
