#pragma once
// All mistakes of one file, with their places.
#include <toml++/toml.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace shmoo::scene {

class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  // At a value; it counts as bad from then on, so that nothing is said twice about it.
  void add(const toml::node& at, std::string message);
  void add(const toml::source_region& at, std::string message);

  void mark_bad(const toml::node& node) { bad_.insert(&node); }
  bool bad(const toml::node& node) const { return bad_.contains(&node); }
  std::size_t count() const { return diagnostics_.size(); }
  base::Location location(const toml::source_region& at) const;

  // Throws base::InputError, as does adding without end, with everything that was added, in the order of the file,
  // unless nothing was. Very many mistakes are cut short.
  void finish();

 private:
  std::string file_;
  std::vector<base::Diagnostic> diagnostics_;
  std::set<const toml::node*> bad_;
};

// What follows a name that is not known: "; did you mean 'NAME'? Rest" where one is near, otherwise "; rest".
std::string suggestion(std::string_view given, const std::vector<std::string>& names, std::string rest);

// "a, b, c"; the first of very many.
std::string listed(const std::vector<std::string>& names);

// The text in quotes for a message: cut short where it is long, control characters replaced.
std::string quoted(std::string_view text);

}  // namespace shmoo::scene
