#include <fmt/format.h>

#include "base/error.hpp"
#include "run/plot/plot.hpp"

namespace shmoo::run {

void plot_map(const ResultFile& result, const Entry& field, std::size_t time, const PlotOptions& options,
              const std::filesystem::path& png);
void plot_line(const ResultFile& result, const Entry& field, std::size_t time, const std::filesystem::path& png);

void plot_course(const ResultFile& result, const Entry& field, const std::filesystem::path& png);

void plot_field(const ResultFile& result, const Entry& field, std::size_t time, const PlotOptions& options,
                const std::filesystem::path& png) {
  if (field.shape.empty() || field.shape[0] != result.material.size()) {
    throw base::InputError(
        fmt::format("field {} has no value per particle and cannot be drawn; export it with --to csv", field.name));
  }
  if (result.dimension == 0)
    plot_course(result, field, png);
  else if (result.dimension == 1)
    plot_line(result, field, time, png);
  else
    plot_map(result, field, time, options, png);
}

}  // namespace shmoo::run
