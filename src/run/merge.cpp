#include "run/merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "run/hdf5.hpp"
#include "run/result_write.hpp"

namespace shmoo::run {
namespace {

using Path = std::filesystem::path;

std::size_t realisations_wanted(const std::vector<Path>& parts) try {
  std::size_t wanted = 0;
  for (const auto& part : parts) wanted = std::max(wanted, glance_at(part).realisations);
  return wanted;
} catch (const base::RunError& error) {
  throw base::InputError(fmt::format("cannot merge: {}", error.what()));
}

scene::Scene scene_of(const Path& part, const Workshop& workshop) {
  const auto file = h5::open_for_reading(part);
  const auto model = h5::open(file, "/model");
  auto scene = workshop.read_text(h5::read_text(file, "/model/text"), h5::get_text(model, "file"));
  scene.run.seed = h5::get_whole(file, "seed");
  return scene;
}

std::vector<coupling::Experiment::Derived> derived_of(const Path& part) {
  const auto file = h5::open_for_reading(part);
  const auto names = h5::read_texts(file, "/derived/name"), units = h5::read_texts(file, "/derived/unit"),
             reasons = h5::read_texts(file, "/derived/why");
  const auto values = h5::read<double>(file, "/derived/value");
  std::vector<coupling::Experiment::Derived> derived;
  for (std::size_t i = 0; i < names.size(); ++i) derived.push_back({names[i], values[i], units[i], reasons[i]});
  return derived;
}

Provenance provenance_of(const Path& first, const std::string& command) {
  const auto file = h5::open_for_reading(first);
  const auto told = h5::open(file, "/provenance");
  Provenance provenance;
  provenance.host = host_name();
  provenance.started = provenance.updated = utc_now();
  provenance.cpu_seconds_shared = h5::get_number(told, "cpu_seconds_shared");
  provenance.cpu_seconds_per_realisation = h5::get_number(told, "cpu_seconds_per_realisation");
  provenance.command = command;
  return provenance;
}

void require_apart(const Results& all, const Results& part, const Path& path) {
  for (std::size_t k = 0; k < part.done.size(); ++k) {
    if (part.done[k] == 0 || all.done[k] == 0) continue;
    throw base::InputError(fmt::format(
        "{} holds realisation {}, which a part named before it holds, too; name each part once, and run parts "
        "with 'shmoo run MODEL -n N --part I/K', each I in 1 .. K once",
        path.string(), k));
  }
}

}  // namespace

MergeEnd merge_results(const std::vector<Path>& parts, const Path& output, const Workshop& workshop,
                       const std::string& command) {
  const std::size_t wanted = realisations_wanted(parts);
  auto scene = scene_of(parts.front(), workshop);
  scene.run.realisations = int(wanted);
  const auto experiment = workshop.make(std::move(scene));
  Description description(*experiment);
  description.derived = derived_of(parts.front());
  const std::size_t species = experiment->scene().species.size();
  Results all(experiment->layout(), species, wanted);
  for (const auto& path : parts) {
    Results part(experiment->layout(), species, wanted);
    restore_result(path, description, part);
    require_apart(all, part, path);
    all.merge(part);
  }
  write_result(output, description, all, {all.complete() ? "done" : "part", ""}, provenance_of(parts.front(), command));
  return {all.done_count(), wanted};
}

}  // namespace shmoo::run
