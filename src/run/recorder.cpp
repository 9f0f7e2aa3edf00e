#include "run/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.hpp"

namespace shmoo::run {

std::size_t cells(const coupling::FieldInfo& info) {
  std::size_t product = 1;
  for (const auto extent : info.shape) product *= extent;
  return product;
}

Recorder::Recorder(const coupling::RecordLayout& layout, Source source)
    : shared_fields(layout.fields.size()),
      varying_fields(layout.fields.size()),
      observables(layout.observables.size()),
      layout_(layout),
      source_(source),
      seen_fields_(layout.fields.size()),
      seen_observables_(layout.observables.size()) {
  for (const auto& info : layout.fields) {
    quanta_.push_back(info.whole || info.shared ? base::FixedPoint::whole() : base::FixedPoint(info.scale));
  }
}

void Recorder::check(const char* kind, const coupling::FieldInfo& info, std::size_t time, std::size_t size, Seen& seen,
                     std::size_t index) {
  if (source_ == Source::preparation && !info.shared) {
    throw base::RunError(fmt::format("{} {} varies, but was recorded before the first realisation", kind, info.name));
  }
  if (time >= layout_.times.size() || size != cells(info)) {
    throw base::RunError(fmt::format("{} {} at record {} has {} values; {} at records below {} were announced", kind,
                                     info.name, time, size, cells(info), layout_.times.size()));
  }
  seen[index].resize(layout_.times.size(), false);
  seen[index][time] = true;
}

void Recorder::field(std::size_t time, std::size_t field, coupling::Values values) {
  const auto& info = layout_.fields.at(field);
  std::visit(
      [&](const auto data) {
        check("field", info, time, data.size(), seen_fields_, field);
        const auto offset = static_cast<std::ptrdiff_t>(time * data.size());
        const auto all = layout_.times.size() * data.size();
        if (info.shared) {
          shared_fields[field].resize(all);
          std::transform(data.begin(), data.end(), shared_fields[field].begin() + offset,
                         [](auto x) { return static_cast<double>(x); });
          return;
        }
        varying_fields[field].resize(all);
        try {
          std::transform(data.begin(), data.end(), varying_fields[field].begin() + offset,
                         [&](auto x) { return quanta_[field](static_cast<double>(x)); });
        } catch (const std::range_error& error) {
          throw base::RunError(fmt::format("field {} at t = {} s: {}", info.name, layout_.times[time], error.what()));
        }
      },
      values);
}

void Recorder::observable(std::size_t time, std::size_t observable, coupling::Values values) {
  const auto& info = layout_.observables.at(observable);
  std::visit(
      [&](const auto data) {
        check("observable", info, time, data.size(), seen_observables_, observable);
        observables[observable].resize(layout_.times.size() * data.size());
        for (std::size_t i = 0; i < data.size(); ++i) {
          const auto value = static_cast<double>(data[i]);
          if (!std::isfinite(value)) {
            throw base::RunError(fmt::format("observable {} at t = {} s is {}, not a finite number", info.name,
                                             layout_.times[time], value));
          }
          observables[observable][time * data.size() + i] = value;
        }
      },
      values);
}

void Recorder::require_complete() const {
  const auto require = [&](const char* kind, const coupling::FieldInfo& info, const std::vector<bool>& seen) {
    if (seen.empty() && (info.shared || source_ == Source::preparation || layout_.times.empty())) return;
    const auto gap = std::find(seen.begin(), seen.end(), false);
    if (!seen.empty() && gap == seen.end()) return;
    throw base::RunError(fmt::format("{} {} was not recorded at t = {} s", kind, info.name,
                                     layout_.times[static_cast<std::size_t>(gap - seen.begin())]));
  };
  for (std::size_t f = 0; f < layout_.fields.size(); ++f) require("field", layout_.fields[f], seen_fields_[f]);
  for (std::size_t o = 0; o < layout_.observables.size(); ++o)
    require("observable", layout_.observables[o], seen_observables_[o]);
}

}  // namespace shmoo::run
