#include "coupling/well_mixed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>

#include "coupling/well.hpp"

namespace shmoo::coupling {
namespace {

class WellMixed final : public Experiment {
 public:
  explicit WellMixed(Judgement judgement)
      : scene_(std::move(judgement.scene)), notes_(std::move(judgement.notes)), plan_(scene_, judgement.reference) {
    derived_ = std::move(judgement.derived);
    derived_.push_back({"splitting_step", plan_.step.value, "s", plan_.step.why});
    if (plan_.step.error > 0.0) derived_.push_back(splitting_error(plan_.step));
    wells_.push_back(std::make_unique<Well>(plan_));  // so that all mistakes are found now
  }

  const scene::Scene& scene() const override { return scene_; }
  const RecordLayout& layout() const override { return plan_.records.layout(); }
  std::size_t particles() const override { return 1; }
  std::vector<std::int32_t> material_of_particle() const override { return {0}; }
  std::vector<std::array<double, 3>> start_position() const override { return {{0.0, 0.0, 0.0}}; }
  std::vector<Derived> derived() const override { return derived_; }
  std::vector<std::string> notes() const override { return notes_; }

  bool prepare(RecordSink& sink, const Progress& progress) override {
    return plan_.random() || tell(0, sink, progress, alike_);
  }

  bool realise(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) override {
    if (plan_.random()) return tell(k, sink, progress, outcome);
    outcome = alike_;
    return true;
  }

 private:
  bool tell(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) {
    auto well = borrow();
    const bool finished = well->realise({scene_.run.seed, k}, sink, progress, outcome);
    const std::scoped_lock lock(resting_);
    wells_.push_back(std::move(well));
    return finished;
  }

  std::unique_ptr<Well> borrow() {
    {
      const std::scoped_lock lock(resting_);
      if (!wells_.empty()) {
        auto well = std::move(wells_.back());
        wells_.pop_back();
        return well;
      }
    }
    return std::make_unique<Well>(plan_);
  }

  scene::Scene scene_;
  std::vector<std::string> notes_;
  WellPlan plan_;
  std::vector<Derived> derived_;
  std::mutex resting_;
  std::vector<std::unique_ptr<Well>> wells_;  // that no thread uses now
  Outcome alike_;                             // where nothing is random: the outcome of every realisation
};

}  // namespace

std::unique_ptr<Experiment> make_well_mixed(Judgement judgement) {
  return std::make_unique<WellMixed>(std::move(judgement));
}

}  // namespace shmoo::coupling
