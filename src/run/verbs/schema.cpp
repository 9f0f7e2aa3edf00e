// shmoo schema: the JSON Schema of the model file.
#include <fmt/format.h>

#include "run/verbs/verbs.hpp"

namespace shmoo::run {

void declare_schema(CLI::App& app, Desk& desk) {
  app.add_subcommand("schema", "Print the JSON Schema of the model file, for editors")->callback([&desk] {
    fmt::print("{}\n", desk.workshop.schema());
  });
}

}  // namespace shmoo::run
