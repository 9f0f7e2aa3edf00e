#pragma once
// What a run can record, described once, and the sink that receives it. Arrays are ordered by persistent particle id.
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace shmoo::coupling {

struct FieldInfo {
  std::string name;                // "L", "velocity", "RL_at_wall"
  std::string unit;                // "molecules", "m/s"
  bool whole = false;              // whole numbers (exact integer statistics) or real
  bool shared = false;             // the same in every realisation (kept once); otherwise it has statistics
  std::vector<std::size_t> shape;  // [particles], [particles, D], [bins], or {} for a scalar
  double scale = 1.0;              // typical magnitude; sets the quantum of exact sums and the bins of quantiles
  std::vector<double> axis;        // bin centres of a profile [m]; otherwise empty
};

// Everything that one experiment records: fields live under /fields, observables under /observables.
struct RecordLayout {
  std::vector<double> times;  // [s]
  std::vector<FieldInfo> fields;
  std::vector<FieldInfo> observables;
};

using Values = std::variant<std::span<const std::int64_t>, std::span<const double>>;

// Receives the values of one realisation in the order of time. Shared fields are sent to realisation-independent
// storage once.
class RecordSink {
 public:
  virtual ~RecordSink() = default;
  virtual void field(std::size_t time, std::size_t field, Values values) = 0;
  virtual void observable(std::size_t time, std::size_t observable, Values values) = 0;
};

}  // namespace shmoo::coupling
