#pragma once
// Pictures of results.
#include <filesystem>
#include <optional>

#include "run/plot/style.hpp"
#include "run/result_file.hpp"

namespace shmoo::run {

struct PlotOptions {
  bool arrows = false;  // on maps of vector fields
};

// A field over the particles at a record: a map in 2-D (in 3-D of the middle plane across z), beside it the deviation
// over the realisations; a curve with its spread in 1-D. Vector fields show their magnitude (of the mean).
void plot_field(const ResultFile& result, const Entry& field, std::size_t time, const PlotOptions& options,
                const std::filesystem::path& png);

// A field against the angle round the middle of the particles that hold it, with its spread: rings and shells, 2-D.
void plot_around(const ResultFile& result, const Entry& field, std::size_t time, const std::filesystem::path& png);

// A named observable: its course over time, or its profile at a record, with the spread over the realisations.
void plot_observable(const ResultFile& result, const Entry& observable, std::size_t time,
                     const std::filesystem::path& png);

// Which particles hold a field: those of its home materials; all but walls for the fluid's own fields.
std::vector<bool> holders(const ResultFile& result, const Entry& field);

// One value per particle: the value, or the magnitude of a vector.
std::vector<double> magnitudes(const std::vector<double>& values, std::size_t components);

// "mean of 100 realisations", "one realisation", "the same in all realisations"
std::string ensemble_text(const ResultFile& result, const Entry& entry);

}  // namespace shmoo::run
