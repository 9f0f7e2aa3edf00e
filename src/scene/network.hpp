#pragma once
// `network = "file.xml"`: an SBML network in place of what a model file would say of it.
#include <toml++/toml.h>

#include <string>

namespace shmoo::scene {

// Puts what the network says into the document of `file`, beside which its path begins: what the file itself says stands,
// and lists are joined, the network's first. Nothing where there is no key `network`. Throws base::InputError.
bool resolve_network(toml::table& root, const std::string& file);

}  // namespace shmoo::scene
