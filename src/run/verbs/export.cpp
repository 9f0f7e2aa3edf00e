// shmoo export OUT.h5 --to vtk|csv -o DIR: a result for other programs.
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "run/export/export.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {

void declare_export(CLI::App& app, Desk&) {
  struct Wish {
    std::string result, format, folder;
  };
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("export", "Write a result for ParaView (vtk) or as tables (csv)");
  verb->add_option("OUT.h5", wish->result, "a result of 'shmoo run'")->required();
  verb->add_option("--to", wish->format, "vtk or csv")->required();
  verb->add_option("-o,--output", wish->folder, "the folder to write into; it is made where it does not exist")
      ->required();
  verb->callback([wish] {
    const std::vector<std::string> formats{"vtk", "csv"};
    if (std::find(formats.begin(), formats.end(), wish->format) == formats.end()) {
      throw base::InputError(fmt::format("--to is '{}'{}; allowed: {}", wish->format,
                                         base::did_you_mean(wish->format, formats), base::list_of(formats)));
    }
    const ResultFile result(wish->result);
    const auto written = wish->format == "vtk" ? export_vtk(result, wish->folder) : export_csv(result, wish->folder);
    for (const auto& path : written) fmt::print("{}\n", path.string());
  });
}

}  // namespace shmoo::run
