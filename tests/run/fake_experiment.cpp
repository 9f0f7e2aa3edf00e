#include "fake_experiment.hpp"

namespace shmoo::run {
namespace {

coupling::FieldInfo info(const char* name, const char* unit, bool whole, bool shared, std::vector<std::size_t> shape,
                         double scale) {
  return {name, unit, whole, shared, std::move(shape), scale, {}};
}

}  // namespace

FakeExperiment::FakeExperiment(int dimension, std::size_t side, std::size_t records) {
  scene_.title = "A walk \"in\" the dark";
  scene_.file = "walk.toml";
  scene_.text = "title = 'walk'\n# µm\n";
  scene_.dimension = dimension;
  scene_.depth = 1e-6;
  const double spacing = 1e-6;
  scene_.domain.spacing = spacing;
  scene_.domain.upper = {side * spacing, dimension > 1 ? side * spacing : 0, dimension > 2 ? side * spacing : 0};
  scene_.materials.resize(2);
  scene_.materials[0].name = "medium";
  scene_.materials[1].name = "wall";
  scene_.materials[1].type = scene::MaterialType::wall;
  scene_.species = {{"L", {0}, 1e-10, scene::SpeciesMethod::stochastic},
                    {"D", {0, 1}, 1e-10, scene::SpeciesMethod::deterministic}};
  scene_.run.seed = 7;
  scene_.run.realisations = 6;
  const std::size_t ny = dimension > 1 ? side : 1, nz = dimension > 2 ? side : 1;
  for (std::size_t z = 0; z < nz; ++z) {
    for (std::size_t y = 0; y < ny; ++y) {
      for (std::size_t x = 0; x < side; ++x) {
        position_.push_back(
            {(x + 0.5) * spacing, dimension > 1 ? (y + 0.5) * spacing : 0, dimension > 2 ? (z + 0.5) * spacing : 0});
        material_.push_back(x == 0 ? 1 : 0);
      }
    }
  }
  const auto n = position_.size();
  const auto components = static_cast<std::size_t>(dimension);
  for (std::size_t t = 0; t < records; ++t) layout_.times.push_back(0.01 * static_cast<double>(t));
  layout_.fields = {info("velocity", "m/s", false, true, {n, components}, 1e-4),
                    info("L", "molecules", true, false, {n}, 100), info("D", "molecules", false, false, {n}, 50)};
  layout_.observables = {info("total_L", "molecules", true, false, {}, 1),
                         info("row_of_L", "molecules/m^3", false, false, {side}, 1),
                         info("energy", "J", false, true, {}, 1)};
  for (std::size_t x = 0; x < side; ++x) layout_.observables[1].axis.push_back((x + 0.5) * spacing);
}

std::int64_t FakeExperiment::count(std::uint32_t k, std::size_t t, std::size_t i) const {
  base::RandomSequence random({scene_.run.seed, k}, base::Stream::test, t, static_cast<std::uint32_t>(i));
  const double x = position_[i][0] / scene_.domain.upper[0];
  return base::poisson(random, 100 * std::exp(-3 * x) * static_cast<double>(t + 1));
}

double FakeExperiment::amount(std::uint32_t k, std::size_t t, std::size_t i) const {
  base::RandomSequence random({scene_.run.seed, k}, base::Stream::test, t, static_cast<std::uint32_t>(i), 1);
  return 50 + 10 * random.normal();
}

bool FakeExperiment::prepare(coupling::RecordSink& sink, const coupling::Progress&) {
  const auto components = static_cast<std::size_t>(scene_.dimension);
  for (std::size_t t = 0; t < layout_.times.size(); ++t) {
    std::vector<double> velocity;
    for (const auto& p : position_) {
      const double s = p[1] / std::max(1e-30, scene_.domain.upper[1]);
      for (std::size_t c = 0; c < components; ++c)
        velocity.push_back(c == 0 ? 1e-4 * 4 * s * (1 - s) : 1e-5 * std::sin(6 * s));
    }
    sink.field(t, 0, std::span<const double>(velocity));
    const std::vector<double> energy{1e-15 * static_cast<double>(t)};
    sink.observable(t, 2, std::span<const double>(energy));
  }
  return true;
}

bool FakeExperiment::realise(std::uint32_t k, coupling::RecordSink& sink, const coupling::Progress& progress,
                             coupling::Outcome& outcome) {
  if (before) before(k);
  const auto side = layout_.observables[1].axis.size();
  std::int64_t total = 0;
  for (std::size_t t = 0; t < layout_.times.size(); ++t) {
    if (progress.stop && progress.stop()) return false;
    std::vector<std::int64_t> counts;
    std::vector<double> amounts, row(side, 0.0);
    total = 0;
    for (std::size_t i = 0; i < position_.size(); ++i) {
      counts.push_back(count(k, t, i));
      amounts.push_back(amount(k, t, i));
      total += counts.back();
      row[i % side] +=
          1e18 * static_cast<double>(counts.back()) * static_cast<double>(side) / static_cast<double>(position_.size());
    }
    sink.field(t, 1, std::span<const std::int64_t>(counts));
    sink.field(t, 2, std::span<const double>(amounts));
    sink.observable(t, 0, std::span<const std::int64_t>(&total, 1));
    sink.observable(t, 1, std::span<const double>(row));
    if (progress.report) progress.report(static_cast<double>(t + 1) / static_cast<double>(layout_.times.size()));
    std::this_thread::sleep_for(
        std::chrono::duration<double>(seconds_per_realisation / static_cast<double>(layout_.times.size())));
  }
  outcome.ledger.counts.resize(2);
  outcome.ledger.amounts.resize(2);
  outcome.ledger.counts[0] = {.initial = 10, .created = total, .destroyed = 0, .entered = 3, .left = 1};
  outcome.ledger.amounts[1] = {.initial = 0.5, .created = 0.25 * k, .destroyed = 0, .entered = 0, .left = 0};
  outcome.reaction_events = 100 + k;
  outcome.jump_events = 1000 + k;
  return true;
}

}  // namespace shmoo::run
