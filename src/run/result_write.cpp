#include "run/result_write.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "run/hdf5.hpp"

namespace shmoo::run {
namespace {

void write_model(hid_t file, const Description& description) {
  const auto& scene = description.scene;
  const auto group = h5::make_group(file, "/model");
  h5::set(group, "title", scene.title);
  h5::set(group, "file", scene.file);
  h5::set(group, "sha256", description.hash);
  h5::set(group, "dimension", static_cast<std::int64_t>(scene.dimension));
  if (scene.axisymmetric) h5::set(group, "axisymmetric", std::int64_t{1});
  h5::set(group, "depth", scene.depth);
  h5::set(group, "depth_unit", scene.dimension == 3 ? "1" : scene.dimension == 2 ? "m" : "m^2");
  h5::set(group, "spacing", scene.domain.spacing);
  h5::set(group, "lower", std::vector<double>(scene.domain.lower.begin(), scene.domain.lower.end()));
  h5::set(group, "upper", std::vector<double>(scene.domain.upper.begin(), scene.domain.upper.end()));
  h5::set(group, "length_unit", std::string("m"));
  h5::write_text(file, "/model/text", scene.text);
}

const char* name_of(scene::MaterialType type) {
  switch (type) {
    case scene::MaterialType::fluid:
      return "fluid";
    case scene::MaterialType::wall:
      return "wall";
    case scene::MaterialType::solid:
      return "solid";
    case scene::MaterialType::still:
      break;
  }
  return "still";
}

void write_particles(hid_t file, const Description& description) {
  const auto count = description.material.size();
  std::vector<std::int64_t> id(count);
  for (std::size_t i = 0; i < count; ++i) id[i] = static_cast<std::int64_t>(i);
  h5::write<std::int64_t>(file, "/particles/id", {count}, id);
  h5::write<std::int32_t>(file, "/particles/material", {count}, description.material);
  h5::Strings names;
  for (const auto& material : description.scene.materials) names.push_back(material.name);
  h5::write_texts(file, "/particles/material_names", names);
  h5::Strings types;
  for (const auto& material : description.scene.materials) types.emplace_back(name_of(material.type));
  h5::write_texts(file, "/particles/material_types", types);
  std::vector<double> flat;
  for (const auto& position : description.start_position) flat.insert(flat.end(), position.begin(), position.end());
  const auto start = h5::write<double>(file, "/particles/start_position", {count, 3}, flat);
  h5::set(start, "unit", std::string("m"));
}

void write_derived(hid_t file, const Description& description) {
  h5::Strings names, units, reasons;
  std::vector<double> values;
  for (const auto& derived : description.derived) {
    names.push_back(derived.name), units.push_back(derived.unit), reasons.push_back(derived.why);
    values.push_back(derived.value);
  }
  h5::write_texts(file, "/derived/name", names);
  h5::write<double>(file, "/derived/value", {values.size()}, values);
  h5::write_texts(file, "/derived/unit", units);
  h5::write_texts(file, "/derived/why", reasons);
}

template <h5::Number T>
void write_account(hid_t file, const std::string& name, std::size_t species, const Results& results,
                   const std::vector<T>& all) {
  const auto realisations = results.done.size();
  std::vector<T> rows, total(ledger_kinds, T{});
  for (std::size_t k = 0; k < realisations; ++k) {
    const auto* row = &all[(k * results.species + species) * ledger_kinds];
    rows.insert(rows.end(), row, row + ledger_kinds);
    for (std::size_t kind = 0; kind < ledger_kinds; ++kind) total[kind] += row[kind];
  }
  const auto group = h5::make_group(file, "/ledger/" + name);
  h5::set(group, "kinds", h5::Strings{"initial", "created", "destroyed", "entered", "left"});
  h5::set(group, "unit", std::string("molecules"));
  h5::write<T>(group, "total", {ledger_kinds}, total);
  h5::write<T>(group, "per_realisation", {realisations, ledger_kinds}, rows);
}

void write_ledger(hid_t file, const Description& description, const Results& results) {
  h5::make_group(file, "/ledger");
  for (std::size_t s = 0; s < results.species; ++s) {
    const auto& species = description.scene.species[s];
    if (species.method == scene::SpeciesMethod::stochastic)
      write_account(file, species.name, s, results, results.counts);
    else
      write_account(file, species.name, s, results, results.amounts);
  }
  const auto n = results.done.size();
  h5::write<std::uint8_t>(file, "/realisations/done", {n}, results.done);
  h5::write<std::uint8_t>(file, "/realisations/balanced", {n}, results.balanced);
  h5::write<std::uint64_t>(file, "/realisations/reaction_events", {n}, results.reaction_events);
  h5::write<std::uint64_t>(file, "/realisations/jump_events", {n}, results.jump_events);
}

void write_provenance(hid_t file, const Provenance& provenance) {
  const auto group = h5::make_group(file, "/provenance");
  h5::set(group, "host", provenance.host);
  h5::set(group, "started", provenance.started);
  h5::set(group, "updated", provenance.updated);
  h5::set(group, "seconds", provenance.seconds);
  h5::set(group, "cpu_seconds_shared", provenance.cpu_seconds_shared);
  h5::set(group, "cpu_seconds_per_realisation", provenance.cpu_seconds_per_realisation);
  h5::set(group, "threads", static_cast<std::int64_t>(provenance.threads));
  h5::set(group, "command", provenance.command);
  h5::set(group, "version", build().version);
  h5::set(group, "compiler", build().compiler);
  h5::set(group, "flags", build().flags);
  h5::set(group, "architecture", build().architecture);
  h5::set(group, "revision", build().revision);
}

}  // namespace

void write_result(const std::filesystem::path& path, const Description& description, const Results& results,
                  const Status& status, const Provenance& provenance) {
  h5::write_whole_file(path, [&](hid_t file) {
    h5::set(file, "format", std::string("shmoo result"));
    h5::set(file, "format_version", std::int64_t{1});
    h5::set(file, "status", status.word);
    h5::set(file, "message", status.message);
    h5::set(file, "seed", description.scene.run.seed);
    h5::set(file, "realisations", static_cast<std::uint64_t>(results.done.size()));
    h5::set(file, "realisations_done", static_cast<std::uint64_t>(results.done_count()));
    write_model(file, description);
    write_particles(file, description);
    const auto time = h5::write<double>(file, "/time", {results.layout.times.size()}, results.layout.times);
    h5::set(time, "unit", std::string("s"));
    write_derived(file, description);
    write_statistics(file, description, results);
    write_ledger(file, description, results);
    write_checkpoint(file, results);
    write_provenance(file, provenance);
  });
}

}  // namespace shmoo::run
