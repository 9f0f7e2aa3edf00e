#pragma once
// A model file as a TOML document: read, guarded against what no person writes, parsed, overrides applied.
#include <toml++/toml.h>

#include <string>

#include "scene/read.hpp"

namespace shmoo::scene {

// The bytes of a file. Throws base::InputError where it is missing, a directory, or larger than 16 MiB. `kind`: "model" or
// "study", for messages.
std::string read_bytes(const std::string& file, std::string_view kind = "model");

struct Document {
  toml::table root;
  std::string text;  // what root says; the given text where nothing was overridden
};

// Throws base::InputError with the one syntax error, or with what is wrong with the overrides.
// `needs`: what an empty file lacks.
Document parse_document(const std::string& text, const std::string& file, const Overrides& overrides,
                        std::string_view needs = "a model needs at least dimension, [domain], [materials] and [run]");

}  // namespace shmoo::scene
