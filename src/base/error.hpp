#pragma once
// Errors that reach a user. Each says what came, what is allowed and what to do.
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace shmoo::base {

struct Location {
  std::string file;
  int line = 0;    // from 1; 0 = unknown
  int column = 0;  // from 1; 0 = unknown
};

// One mistake in what the user wrote.
struct Diagnostic {
  Location where;
  std::string message;

  std::string text() const;  // "file:line:column: error: message"
};

// The model or the arguments are wrong: exit code 1. Carries every mistake that was found.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Diagnostic> diagnostics);
  explicit InputError(const std::string& message) : InputError(std::vector<Diagnostic>{{{}, message}}) {}
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

// A run failed after it had begun: exit code 2.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace shmoo::base
