#pragma once
// Keeps what one realisation records until it has ended, so that one that is stopped or fails leaves no trace.
#include <cstdint>
#include <string>
#include <vector>

#include "base/exact.hpp"
#include "coupling/record.hpp"

namespace shmoo::run {

enum class Part { shared, varying };  // of a layout: what all realisations share, or what has statistics

inline bool belongs(const coupling::FieldInfo& info, Part part) { return info.shared == (part == Part::shared); }

std::size_t cells(const coupling::FieldInfo& info);  // values at one time

class Recorder final : public coupling::RecordSink {
 public:
  Recorder(const coupling::RecordLayout& layout, Part part);

  // base::RunError for what is no number, is too large for exact sums, or has another size than the layout says.
  void field(std::size_t time, std::size_t field, coupling::Values values) override;
  void observable(std::size_t time, std::size_t observable, coupling::Values values) override;

  // base::RunError where a record is missing.
  void require_complete() const;

  std::vector<std::vector<double>> shared_fields;         // [field][time * cells], Part::shared
  std::vector<std::vector<std::int64_t>> varying_fields;  // [field][time * cells] in quanta, Part::varying
  std::vector<std::vector<double>> observables;           // [observable][time * cells]

 private:
  using Seen = std::vector<std::vector<bool>>;
  void check(const char* kind, const coupling::FieldInfo& info, std::size_t time, std::size_t size, Seen& seen,
             std::size_t index);

  const coupling::RecordLayout& layout_;
  Part part_;
  std::vector<base::FixedPoint> quanta_;
  Seen seen_fields_, seen_observables_;
};

}  // namespace shmoo::run
