#pragma once
// A scene made ready to run: particles placed, network compiled, what is common to all realisations computed once.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "coupling/record.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

// What one finished realisation reports besides its records.
struct Outcome {
  rdme::Ledger ledger;
  bool balanced = true;  // the ledger accounts for every molecule
  std::uint64_t reaction_events = 0, jump_events = 0;
};

struct Progress {
  std::function<bool()> stop;               // true: give up as soon as possible (the realisation is then discarded)
  std::function<void(double done)> report;  // fraction of this realisation in [0, 1]; may be called from any thread
};

class Experiment {
 public:
  virtual ~Experiment() = default;

  virtual const scene::Scene& scene() const = 0;
  virtual const RecordLayout& layout() const = 0;
  virtual std::size_t particles() const = 0;
  virtual std::vector<std::int32_t> material_of_particle() const = 0;     // by id
  virtual std::vector<std::array<double, 3>> start_position() const = 0;  // by id, [m]

  // Named derived numbers with unit and origin: time steps, sound speed, splitting step, jump rates. For reports and
  // /derived.
  struct Derived {
    std::string name;
    double value;
    std::string unit;
    std::string why;
  };
  virtual std::vector<Derived> derived() const = 0;

  // What a user should know before it runs: what rules decided, and limits that are not kept.
  virtual std::vector<std::string> notes() const { return {}; }

  // Runs what all realisations share (a flow that nothing random acts on) and sends shared fields and observables to
  // `sink`. Called once, before any realise(). Returns false if stopped.
  virtual bool prepare(RecordSink& sink, const Progress& progress) = 0;

  // Mean events per second [1/s] in equal parts of a realisation of sampled chemistry, foretold after prepare() without
  // running one (coupling/activity.hpp). Empty where the flow moves or nothing is foretold.
  virtual std::vector<double> activity(const std::function<bool()>& /*stop*/) const { return {}; }

  // Runs realisation k to the end; thread-safe after prepare(). Its result depends on the scene and k only, never on
  // how many others run or where. Returns false if stopped.
  virtual bool realise(std::uint32_t k, RecordSink& sink, const Progress& progress, Outcome& outcome) = 0;
};

// Decides first what the scene leaves to "auto". Throws base::InputError where the scene cannot be built (a region or
// home without particles, ...) or is beyond a limit that makes its run worthless.
std::unique_ptr<Experiment> make_experiment(scene::Scene scene);

}  // namespace shmoo::coupling
