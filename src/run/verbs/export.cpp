// shmoo export OUT.h5 --to vtk|csv -o DIR, or MODEL --to sbml -o FILE: a result or a model for other programs.
#include <fmt/format.h>

#include <fstream>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "coupling/rules/numbers.hpp"
#include "run/ensemble.hpp"
#include "run/export/export.hpp"
#include "run/verbs/verbs.hpp"
#include "scene/sbml/export.hpp"

namespace shmoo::run {
namespace {

void write_sbml(const scene::Scene& scene, const std::string& file) {
  double volume = scene.depth;  // of the domain [m^3]
  for (std::size_t a = 0; a < std::size_t(scene.dimension); ++a)
    volume *= scene.domain.upper[a] - scene.domain.lower[a];
  std::vector<double> molecules;
  for (const auto& one : coupling::numbers_of(scene).species) molecules.push_back(one.start);
  require_writable(file);
  std::ofstream(file, std::ios::binary) << scene::export_sbml(scene, molecules, volume);
  fmt::print("{}\n", file);
}

}  // namespace

void declare_export(CLI::App& app, Desk& desk) {
  struct Wish {
    std::string result, format, folder;
  };
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand(
      "export", "Write a result for ParaView (vtk) or as tables (csv), or the network of a model (sbml)");
  verb->add_option("OUT.h5", wish->result, "a result of 'shmoo run'; for sbml a model file")->required();
  verb->add_option("--to", wish->format, "vtk, csv or sbml")->required();
  verb->add_option("-o,--output", wish->folder,
                   "the folder to write into, which is made where it does not exist; for sbml the file")
      ->required();
  verb->callback([wish, &desk] {
    const std::vector<std::string> formats{"vtk", "csv", "sbml"};
    if (std::find(formats.begin(), formats.end(), wish->format) == formats.end()) {
      throw base::InputError(fmt::format("--to is '{}'{}; allowed: {}", wish->format,
                                         base::did_you_mean(wish->format, formats), base::list_of(formats)));
    }
    if (wish->format == "sbml") return write_sbml(desk.workshop.read(wish->result, {}), wish->folder);
    const ResultFile result(wish->result);
    const auto written = wish->format == "vtk" ? export_vtk(result, wish->folder) : export_csv(result, wish->folder);
    for (const auto& path : written) fmt::print("{}\n", path.string());
  });
}

}  // namespace shmoo::run
