#include "run/description.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <ctime>

#include "base/sha256.hpp"
#include "run/build_info.hpp"

namespace shmoo::run {

Description::Description(const coupling::Experiment& experiment)
    : scene(experiment.scene()),
      hash(base::sha256(experiment.scene().text)),
      material(experiment.material_of_particle()),
      start_position(experiment.start_position()),
      derived(experiment.derived()) {}

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

std::string host_name() {
  char name[256] = "unknown";
  if (gethostname(name, sizeof name - 1) != 0) return "unknown";
  return name;
}

const Build& build() {
  static const Build this_build = {SHMOO_VERSION, SHMOO_COMPILER, SHMOO_FLAGS, SHMOO_ARCHITECTURE, SHMOO_REVISION};
  return this_build;
}

}  // namespace shmoo::run
