// /checkpoint, and what it takes to go on from a file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/hdf5.hpp"
#include "run/result_write.hpp"

namespace shmoo::run {
namespace {

std::string place(const coupling::FieldInfo& info) { return "/checkpoint/fields/" + info.name; }

void write_blocks(hid_t file, const coupling::FieldInfo& info, const std::vector<Block>& blocks) {
  const auto group = h5::make_group(file, place(info));
  const auto size = cells(info), times = blocks.size();
  const auto sum = h5::make_dataset<std::uint64_t>(group, "sum", {times, size, 2});
  const auto squares = h5::make_dataset<std::uint64_t>(group, "squares", {times, size, 2});
  const auto first = h5::make_dataset<std::uint32_t>(group, "bins_first", {times, size + 1});
  std::vector<std::uint64_t> offsets{0};
  for (const auto& block : blocks) offsets.push_back(offsets.back() + block.histograms.entries().size());
  h5::write<std::uint64_t>(group, "bins_offset", {offsets.size()}, offsets);
  const auto entries = h5::make_dataset<std::uint32_t>(group, "bins_entries", {offsets.back()});
  for (std::size_t t = 0; t < times; ++t) {
    h5::write_block<std::uint64_t>(sum, {t, 0, 0}, {1, size, 2}, blocks[t].sums.sum_words());
    h5::write_block<std::uint64_t>(squares, {t, 0, 0}, {1, size, 2}, blocks[t].sums.square_words());
    h5::write_block<std::uint32_t>(first, {t, 0}, {1, size + 1}, blocks[t].histograms.first());
    h5::write_block<std::uint32_t>(entries, {offsets[t]}, {offsets[t + 1] - offsets[t]},
                                   blocks[t].histograms.entries());
  }
}

std::vector<Block> read_blocks(hid_t file, const coupling::FieldInfo& info, std::size_t times, std::int64_t samples) {
  const auto at = place(info);
  const auto size = cells(info);
  const auto offsets = h5::read<std::uint64_t>(file, at + "/bins_offset");
  std::vector<Block> blocks;
  for (std::size_t t = 0; t < times; ++t) {
    const auto sum = h5::read_block<std::uint64_t>(file, at + "/sum", {t, 0, 0}, {1, size, 2});
    const auto squares = h5::read_block<std::uint64_t>(file, at + "/squares", {t, 0, 0}, {1, size, 2});
    auto first = h5::read_block<std::uint32_t>(file, at + "/bins_first", {t, 0}, {1, size + 1});
    auto entries =
        h5::read_block<std::uint32_t>(file, at + "/bins_entries", {offsets.at(t)}, {offsets.at(t + 1) - offsets[t]});
    blocks.push_back({base::ExactSums::from_words(samples, sum, squares),
                      base::SparseHistograms::from_arrays(samples, std::move(first), std::move(entries))});
  }
  return blocks;
}

// Rows of the file go first; the rest keeps what it is.
template <class T>
void take_rows(const std::vector<T>& from, std::vector<T>& to) {
  std::copy(from.begin(), from.end(), to.begin());
}

template <h5::Number T>
void read_account(hid_t file, const std::string& name, std::size_t species, std::size_t kept, const Results& results,
                  std::vector<T>& all) {
  const auto rows = h5::read<T>(file, "/ledger/" + name + "/per_realisation");
  for (std::size_t k = 0; k < kept; ++k) {
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(k * ledger_kinds);
    std::copy_n(from, ledger_kinds,
                all.begin() + static_cast<std::ptrdiff_t>((k * results.species + species) * ledger_kinds));
  }
}

void require(bool condition, const std::filesystem::path& path, const std::string& what) {
  if (condition) return;
  throw base::InputError(fmt::format("cannot resume {}: {}", path.string(), what));
}

h5::Strings sorted(h5::Strings names) {
  std::sort(names.begin(), names.end());
  return names;
}

h5::Strings names_of(const std::vector<coupling::FieldInfo>& infos) {
  h5::Strings names;
  for (const auto& info : infos) names.push_back(info.name);
  return sorted(names);
}

void require_same(hid_t file, const std::filesystem::path& path, const Description& description,
                  const Results& results) {
  const auto model = h5::open(file, "/model");
  const auto hash = h5::get_text(model, "sha256");
  require(hash == description.hash, path,
          fmt::format("it was made from another model (its text has SHA-256 {}..., {} with its overrides has {}...); "
                      "run the model it was "
                      "made from, or name another output",
                      hash.substr(0, 12), description.scene.file, description.hash.substr(0, 12)));
  const auto seed = h5::get_whole(file, "seed");
  require(seed == description.scene.run.seed, path,
          fmt::format("it was made with seed {}, not {}; give --seed {}", seed, description.scene.run.seed, seed));
  const auto held = h5::get_whole(file, "realisations_done"), wanted = static_cast<std::uint64_t>(results.done.size());
  const auto done = h5::read<std::uint8_t>(file, "/realisations/done");
  const bool fits = std::all_of(done.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(done.size(), wanted)),
                                done.end(), [](auto d) { return d == 0; });
  require(fits, path,
          fmt::format("it holds {} realisations of {}, more than the {} asked for", held, done.size(), wanted));
  const bool same_records = h5::read<double>(file, "/time") == results.layout.times &&
                            h5::children(file, "/fields") == names_of(results.layout.fields) &&
                            h5::children(file, "/observables") == names_of(results.layout.observables);
  require(same_records, path,
          "another version of the program recorded other things from this model; start again with --force");
}

}  // namespace

void write_checkpoint(hid_t file, const Results& results) {
  const auto group = h5::make_group(file, "/checkpoint");
  h5::set(group, "samples", static_cast<std::int64_t>(results.done_count()));
  for (std::size_t f = 0; f < results.layout.fields.size(); ++f) {
    if (!results.layout.fields[f].shared) write_blocks(file, results.layout.fields[f], results.blocks[f]);
  }
}

void restore_result(const std::filesystem::path& path, const Description& description, Results& results) {
  const auto file = h5::open_for_reading(path);
  require_same(file, path, description, results);
  const auto samples = static_cast<std::int64_t>(h5::get_whole(h5::open(file, "/checkpoint"), "samples"));
  const auto kept = std::min<std::size_t>(h5::get_whole(file, "realisations"), results.done.size());
  const auto take = [&](const char* name, auto& to) {
    auto rows = h5::read<typename std::remove_reference_t<decltype(to)>::value_type>(file, name);
    rows.resize(kept);
    take_rows(rows, to);
  };
  take("/realisations/done", results.done);
  take("/realisations/balanced", results.balanced);
  take("/realisations/reaction_events", results.reaction_events);
  take("/realisations/jump_events", results.jump_events);
  const auto& layout = results.layout;
  const auto take_shared = [&](const std::string& name, std::vector<double>& to) {
    auto values = h5::read<double>(file, name);
    if (!values.empty() && !std::isnan(values.front())) to = std::move(values);
  };
  for (std::size_t f = 0; f < layout.fields.size(); ++f) {
    if (layout.fields[f].shared)
      take_shared("/fields/" + layout.fields[f].name, results.shared_fields[f]);
    else
      results.blocks[f] = read_blocks(file, layout.fields[f], layout.times.size(), samples);
  }
  for (std::size_t o = 0; o < layout.observables.size(); ++o) {
    const auto at = "/observables/" + layout.observables[o].name + "/values";
    if (layout.observables[o].shared) {
      take_shared(at, results.shared_observables[o]);
      continue;
    }
    auto rows = h5::read<double>(file, at);
    rows.resize(kept * layout.times.size() * cells(layout.observables[o]));
    take_rows(rows, results.values[o]);
  }
  for (std::size_t s = 0; s < results.species; ++s) {
    const auto& species = description.scene.species[s];
    if (species.method == scene::SpeciesMethod::stochastic)
      read_account(file, species.name, s, kept, results, results.counts);
    else
      read_account(file, species.name, s, kept, results, results.amounts);
  }
}

Glance glance_at(const std::filesystem::path& path) {
  const auto file = h5::open_for_reading(path);
  if (!h5::has(file, "format") || h5::get_text(file, "format") != "shmoo result") {
    throw base::RunError(fmt::format("{} is an HDF5 file, but not a result of shmoo", path.string()));
  }
  return {h5::get_text(file, "status"), h5::get_text(h5::open(file, "/model"), "title"),
          h5::get_whole(file, "realisations"), h5::get_whole(file, "realisations_done")};
}

}  // namespace shmoo::run
