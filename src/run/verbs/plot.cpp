// shmoo plot OUT.h5: pictures of fields and observables.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "base/error.hpp"
#include "run/export/export.hpp"
#include "run/plot/gallery.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string result, output, field, observable, time;
  bool arrows = false, around = false;
};

// Seconds from "0.8", "0.8 s", "20 ms".
double seconds_of(const std::string& text) {
  static const std::map<std::string, double> units{{"", 1},      {"s", 1},    {"ms", 1e-3},
                                                   {"us", 1e-6}, {"min", 60}, {"h", 3600}};
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string unit(end, text.data() + text.size());
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  if (error != std::errc() || !units.contains(unit)) {
    throw base::InputError(
        fmt::format("--time is '{}'; 'all' or a time such as '0.8 s' is needed (units: s, ms, us, min, h)", text));
  }
  return value * units.at(unit);
}

std::vector<std::size_t> times_of(const Wish& wish, const ResultFile& result) {
  if (result.times.empty()) throw base::InputError(fmt::format("{} holds no records", wish.result));
  if (wish.time.empty()) return {result.times.size() - 1};
  if (wish.time != "all") return {result.nearest_time(seconds_of(wish.time))};
  std::vector<std::size_t> all(result.times.size());
  for (std::size_t t = 0; t < all.size(); ++t) all[t] = t;
  return all;
}

void plot_result(const Wish& wish) {
  const ResultFile result(wish.result);
  if (result.done == 0)
    throw base::InputError(fmt::format("{} holds no finished realisation yet (status {})", wish.result, result.status));
  if (wish.around && wish.field.empty()) throw base::InputError("--around needs --field NAME");
  const auto pictures =
      gallery(result, {wish.field, wish.observable, times_of(wish, result), wish.arrows, wish.around});
  if (pictures.empty()) throw base::InputError(fmt::format("{} holds neither fields nor observables", wish.result));
  if (wish.output.ends_with(".png")) {
    if (pictures.size() > 1) {
      throw base::InputError(fmt::format(
          "{} pictures do not fit into {}; name a folder, or ask for one with --field or --observable and one --time",
          pictures.size(), wish.output));
    }
    pictures.front().draw(wish.output);
    fmt::print("{}\n", wish.output);
    return;
  }
  make_folder(wish.output);
  for (const auto& picture : pictures) {
    const auto png = std::filesystem::path(wish.output) / picture.name;
    picture.draw(png);
    fmt::print("{}\n", png.string());
  }
}

}  // namespace

void declare_plot(CLI::App& app, Desk&) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("plot", "Draw fields and observables of a result as PNG");
  verb->add_option("OUT.h5", wish->result, "a result of 'shmoo run'")->required();
  verb->add_option("-o,--output", wish->output, "a folder, or one file.png")->required();
  verb->add_option("--field", wish->field, "only this field");
  verb->add_option("--observable", wish->observable, "only this observable");
  verb->add_option("--time", wish->time, "the record nearest to this time, or 'all' [the last]");
  verb->add_flag("--arrows", wish->arrows, "arrows on maps of vector fields");
  verb->add_flag("--around", wish->around, "the field against the angle round its middle, with its spread");
  verb->callback([wish] { plot_result(*wish); });
}

}  // namespace shmoo::run
