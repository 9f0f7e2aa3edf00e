#pragma once
// From a model file to a Scene.
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.hpp"

namespace shmoo::scene {

using Overrides = std::vector<std::pair<std::string, std::string>>;  // path ("run.seed", "region.0.diameter"), value as TOML

// Reads, applies the overrides, checks. Throws base::InputError with a lone syntax error or with every other mistake of the
// file at once.
Scene read_scene(const std::string& file, const Overrides& overrides = {});

// The same from text; `file` is only the name in messages.
Scene read_scene_text(const std::string& text, const std::string& file, const Overrides& overrides = {});

// The JSON Schema of the model file, made from the table that checks it.
std::string json_schema();

// The reference of all keys in Markdown, made from the same table; part of docs/model-file.md.
std::string key_reference();

}  // namespace shmoo::scene
