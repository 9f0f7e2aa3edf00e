#pragma once
// Runs a scene in memory, for verification and tests: records land in vectors, apart from the program's own statistics.
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "coupling/experiment.hpp"

namespace shmoo::coupling {

// All values of one realisation (or of what is shared), by name and time index; whole numbers as doubles.
class MemorySink final : public RecordSink {
 public:
  explicit MemorySink(const RecordLayout& layout) : layout_(layout) {}
  void field(std::size_t time, std::size_t field, Values values) override {
    data_[layout_.fields.at(field).name][time] = copy(values);
  }
  void observable(std::size_t time, std::size_t observable, Values values) override {
    observed_[layout_.observables.at(observable).name][time] = copy(values);
  }
  const std::vector<double>& at(const std::string& field, std::size_t time) const { return data_.at(field).at(time); }
  const std::vector<double>& observed(const std::string& observable, std::size_t time) const {
    return observed_.at(observable).at(time);
  }
  const std::map<std::string, std::map<std::size_t, std::vector<double>>>& fields() const { return data_; }
  const std::map<std::string, std::map<std::size_t, std::vector<double>>>& observables() const { return observed_; }

 private:
  static std::vector<double> copy(const Values& values) {
    return std::visit([](const auto& span) { return std::vector<double>(span.begin(), span.end()); }, values);
  }
  const RecordLayout& layout_;
  std::map<std::string, std::map<std::size_t, std::vector<double>>> data_, observed_;
};

// A prepared experiment with what its realisations share.
struct Laboratory {
  explicit Laboratory(scene::Scene scene)
      : experiment(make_experiment(std::move(scene))), shared(experiment->layout()) {
    if (!experiment->prepare(shared, {})) throw base::RunError("stopped");
  }
  MemorySink realise(std::uint32_t k, Outcome* outcome = nullptr) const {
    MemorySink sink(experiment->layout());
    Outcome own;
    experiment->realise(k, sink, {}, outcome ? *outcome : own);
    return sink;
  }
  std::unique_ptr<Experiment> experiment;
  MemorySink shared;
};

}  // namespace shmoo::coupling
