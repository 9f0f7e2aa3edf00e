#pragma once
// What a well-mixed scene records: every species as a field of its one voxel, the observables that the user names, and
// definitions and parameters that events change as observables of their names.
#include <memory>
#include <vector>

#include "coupling/record.hpp"
#include "rdme/expression.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

class WellRecords {
 public:
  // The network must outlive it. `shared`: all realisations are alike.
  WellRecords(const scene::Scene& scene, const rdme::Network& network, std::vector<double> times, bool shared);

  const RecordLayout& layout() const { return layout_; }

  // Formulas are compiled anew for every reader, as one is not to be used by two threads.
  class Reader {
   public:
    explicit Reader(const WellRecords& records);
    void read(std::size_t time, const rdme::State& state, RecordSink& sink);

   private:
    const WellRecords& records_;
    std::vector<rdme::Expression> formulas_;
  };

 private:
  struct Count {
    int species = 0;
    double per_volume = 1;  // [1/m^3]; 1 where molecules are counted
  };
  void add_fields(const scene::Scene& scene, bool shared);
  void add_observables(const scene::Scene& scene, bool shared);
  bool taken(const std::string& observable) const;

  const rdme::Network& network_;
  RecordLayout layout_;
  std::vector<int> field_species_;
  std::vector<Count> counts_;          // the first observables ...
  std::vector<std::string> formulas_;  // ... and those after them
};

}  // namespace shmoo::coupling
