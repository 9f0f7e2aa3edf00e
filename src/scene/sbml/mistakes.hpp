#pragma once
// What of an SBML file cannot be taken over, all at once.
#include <fmt/format.h>
#include <sbml/SBase.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace shmoo::scene::sbml {

class Mistakes {
 public:
  explicit Mistakes(std::string file) : file_(std::move(file)) {}

  void add(const SBase& element, const std::string& message) {
    const std::string id = element.getId().empty() ? "" : fmt::format(" '{}'", element.getId());
    list_.push_back({{file_, static_cast<int>(element.getLine()), static_cast<int>(element.getColumn())},
                     fmt::format("{}{}: {}", element.getElementName(), id, message)});
  }
  void add(int line, const std::string& message) { list_.push_back({{file_, line, 0}, message}); }

  void finish() {
    std::vector<base::Diagnostic> distinct;
    for (base::Diagnostic& one : list_) {
      const auto same = [&](const base::Diagnostic& told) {
        return told.message == one.message && told.where.line == one.where.line;
      };
      if (std::none_of(distinct.begin(), distinct.end(), same)) distinct.push_back(std::move(one));
    }
    if (!distinct.empty()) throw base::InputError(std::move(distinct));
  }

 private:
  std::string file_;
  std::vector<base::Diagnostic> list_;
};

}  // namespace shmoo::scene::sbml
