#pragma once
// An experiment whose numbers are cheap and known: a random walk of counts, a real field beside it and a shared flow.
#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include "base/error.hpp"
#include "base/random.hpp"
#include "coupling/experiment.hpp"

namespace shmoo::run {

class FakeExperiment final : public coupling::Experiment {
 public:
  explicit FakeExperiment(int dimension = 2, std::size_t side = 8, std::size_t records = 4);

  const scene::Scene& scene() const override { return scene_; }
  const coupling::RecordLayout& layout() const override { return layout_; }
  std::size_t particles() const override { return position_.size(); }
  std::vector<std::int32_t> material_of_particle() const override { return material_; }
  std::vector<std::array<double, 3>> start_position() const override { return position_; }
  std::vector<Derived> derived() const override { return {{"step", 1e-3, "s", "a quarter of the jump time"}}; }
  bool prepare(coupling::RecordSink& sink, const coupling::Progress& progress) override;
  bool realise(std::uint32_t k, coupling::RecordSink& sink, const coupling::Progress& progress,
               coupling::Outcome& outcome) override;

  // The count of particle i at record t in realisation k, and the real value beside it.
  std::int64_t count(std::uint32_t k, std::size_t t, std::size_t i) const;
  double amount(std::uint32_t k, std::size_t t, std::size_t i) const;

  scene::Scene scene_;
  coupling::RecordLayout layout_;
  double seconds_per_realisation = 0;
  std::function<void(std::uint32_t)> before;  // called before realisation k; may throw

 private:
  std::vector<std::array<double, 3>> position_;
  std::vector<std::int32_t> material_;
};

}  // namespace shmoo::run
