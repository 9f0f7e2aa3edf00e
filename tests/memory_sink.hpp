#pragma once
// Runs a scene in memory: records land in vectors, and means over realisations are taken here, apart from the program's
// own statistics.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "coupling/experiment.hpp"
#include "scene/read.hpp"

namespace shmoo::test {

// All values of one realisation (or of what is shared), by name and time index; whole numbers as doubles.
class MemorySink final : public coupling::RecordSink {
 public:
  explicit MemorySink(const coupling::RecordLayout& layout) : layout_(layout) {}
  void field(std::size_t time, std::size_t field, coupling::Values values) override {
    data_[layout_.fields.at(field).name][time] = copy(values);
  }
  void observable(std::size_t time, std::size_t observable, coupling::Values values) override {
    observed_[layout_.observables.at(observable).name][time] = copy(values);
  }
  const std::vector<double>& at(const std::string& field, std::size_t time) const { return data_.at(field).at(time); }
  const std::vector<double>& observed(const std::string& observable, std::size_t time) const {
    return observed_.at(observable).at(time);
  }
  const std::map<std::string, std::map<std::size_t, std::vector<double>>>& fields() const { return data_; }
  const std::map<std::string, std::map<std::size_t, std::vector<double>>>& observables() const { return observed_; }

 private:
  static std::vector<double> copy(const coupling::Values& values) {
    return std::visit([](const auto& span) { return std::vector<double>(span.begin(), span.end()); }, values);
  }
  const coupling::RecordLayout& layout_;
  std::map<std::string, std::map<std::size_t, std::vector<double>>> data_, observed_;
};

// A prepared experiment with what its realisations share.
struct Laboratory {
  explicit Laboratory(scene::Scene scene)
      : experiment(coupling::make_experiment(std::move(scene))), shared(experiment->layout()) {
    if (!experiment->prepare(shared, {})) throw base::RunError("stopped");
  }
  MemorySink realise(std::uint32_t k, coupling::Outcome* outcome = nullptr) const {
    MemorySink sink(experiment->layout());
    coupling::Outcome own;
    experiment->realise(k, sink, {}, outcome ? *outcome : own);
    return sink;
  }
  std::unique_ptr<coupling::Experiment> experiment;
  MemorySink shared;
};

inline Laboratory laboratory(const std::string& model, const scene::Overrides& overrides = {}) {
  return Laboratory(scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/" + model, overrides));
}

}  // namespace shmoo::test
