#pragma once
// Keeps what one realisation records until it has ended, so that one that is stopped or fails leaves no trace.
#include <cstdint>
#include <string>
#include <vector>

#include "base/exact.hpp"
#include "coupling/record.hpp"

namespace shmoo::run {

std::size_t cells(const coupling::FieldInfo& info);  // values at one time

class Recorder final : public coupling::RecordSink {
 public:
  enum class Source {
    preparation,  // what all realisations share; nothing else is accepted
    realisation,  // what has statistics must come; what all realisations share may come with it
  };
  Recorder(const coupling::RecordLayout& layout, Source source);

  // base::RunError for what is not a number, is too large for exact sums, or has another size than the layout says.
  void field(std::size_t time, std::size_t field, coupling::Values values) override;
  void observable(std::size_t time, std::size_t observable, coupling::Values values) override;

  // base::RunError where a field or observable came for some times only, or a varying one not at all.
  void require_complete() const;

  // Empty where nothing came.
  std::vector<std::vector<double>> shared_fields;         // [field][time * cells]
  std::vector<std::vector<std::int64_t>> varying_fields;  // [field][time * cells] in quanta
  std::vector<std::vector<double>> observables;           // [observable][time * cells]

 private:
  using Seen = std::vector<std::vector<bool>>;
  void check(const char* kind, const coupling::FieldInfo& info, std::size_t time, std::size_t size, Seen& seen,
             std::size_t index);

  const coupling::RecordLayout& layout_;
  Source source_;
  std::vector<base::FixedPoint> quanta_;  // [field]
  Seen seen_fields_, seen_observables_;
};

}  // namespace shmoo::run
