#pragma once
// The stage that chemistry plays on during an interval: a frame, its voxels, and what the sampler derives from them.
// Built when first asked for and shared by all realisations and threads; forgotten again, where keeping all would take
// too much memory.
#include <functional>
#include <memory>
#include <mutex>

#include "coupling/frame.hpp"
#include "coupling/geometry.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::coupling {

struct Ground {
  rdme::Voxels voxels;
  std::shared_ptr<const rdme::JumpTables> tables;  // null where no species is stochastic
};

template <int D>
class Stage {
 public:
  using Build = std::function<std::shared_ptr<const Ground>(const Frame<D>&)>;

  Stage(Frame<D> frame, Build build, bool keep) : frame_(std::move(frame)), build_(std::move(build)), keep_(keep) {}

  const Frame<D>& frame() const { return frame_; }

  std::shared_ptr<const Ground> ground() const {
    const std::lock_guard lock(mutex_);
    auto ground = recent_.lock();
    if (!ground) recent_ = ground = build_(frame_);
    if (keep_) kept_ = ground;
    return ground;
  }

 private:
  Frame<D> frame_;
  Build build_;
  bool keep_;
  mutable std::mutex mutex_;
  mutable std::weak_ptr<const Ground> recent_;
  mutable std::shared_ptr<const Ground> kept_;
};

// Makes the stages of one experiment.
template <int D>
class StageBuilder {
 public:
  // The references must outlive the builder and its stages.
  StageBuilder(const Geometry<D>& geometry, const scene::Scene& scene, const rdme::Network& network)
      : geometry_(geometry), network_(network) {
    for (const auto& species : scene.species) {
      if (species.method != scene::SpeciesMethod::stochastic || sampler_) continue;
      sampler_ = rdme::make_sampler(scene.numerics, network);
    }
    for (const auto& species : scene.species)
      sampled_.push_back(species.method == scene::SpeciesMethod::stochastic &&
                         scene.numerics.sampler != scene::Sampler::direct);  // which reads written rows
  }

  const Geometry<D>& geometry() const { return geometry_; }
  const rdme::Network& network() const { return network_; }
  bool has_chemistry() const { return network_.species() > 0; }

  std::shared_ptr<const Stage<D>> stage(Frame<D> frame) const {
    constexpr std::size_t pair_bytes = 40, pairs = 30, budget = std::size_t{1} << 30;  // what is kept, about
    const bool keep = frame.steady || kept_ < budget;
    kept_ += frame.position.size() * pairs * pair_bytes;
    const auto build = [this](const Frame<D>& of) {
      auto ground = std::make_shared<Ground>();
      ground->voxels = geometry_.voxels(of, sampled_);
      if (sampler_) ground->tables = sampler_->prepare(ground->voxels);
      return std::shared_ptr<const Ground>(ground);
    };
    return std::make_shared<Stage<D>>(std::move(frame), build, keep);
  }

 private:
  const Geometry<D>& geometry_;
  const rdme::Network& network_;
  std::unique_ptr<rdme::Sampler> sampler_;  // only derives tables
  std::vector<bool> sampled_;               // by species: by samplers that do not need jumps listed
  mutable std::size_t kept_ = 0;            // [bytes], estimate
};

}  // namespace shmoo::coupling
