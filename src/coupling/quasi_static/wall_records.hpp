#pragma once
// What a quasi-static scene records: positions, volumes and species of all particles, and the observables that the user
// names, of chemistry and of the wall's shape.
#include "coupling/frame.hpp"
#include "coupling/quasi_static/wall.hpp"
#include "coupling/record.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"

namespace shmoo::coupling {

class WallRecords {
 public:
  // References must outlive it. `shared`: all realisations are alike.
  WallRecords(const WallPlan& plan, const rdme::Network& network, std::vector<double> times, bool shared);

  const RecordLayout& layout() const { return layout_; }
  const std::vector<std::uint16_t>& material() const { return material_; }  // by particle

  void read(std::size_t time, const Wall& wall, const rdme::State& state, RecordSink& sink) const;

 private:
  void add_fields(const rdme::Network& network, bool shared);
  double shape(scene::ObservableType type, const Wall& wall) const;

  const WallPlan& plan_;
  std::vector<std::uint16_t> material_;
  RecordLayout layout_;
  std::vector<int> species_;  // by field; negative: what is no species
};

}  // namespace shmoo::coupling
