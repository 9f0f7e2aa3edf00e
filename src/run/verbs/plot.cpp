// shmoo plot OUT.h5: pictures of fields and observables.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "base/error.hpp"
#include "run/export/export.hpp"
#include "run/plot/plot.hpp"
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

std::string safe(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == '\\' || c == ' '; }, '_');
  return name;
}

// One picture: what draws it, and its name in a folder.
struct Picture {
  std::string name;
  std::function<void(const std::filesystem::path&)> draw;
};

std::vector<Picture> pictures_of(const Wish& wish, const ResultFile& result) {
  std::vector<Picture> pictures;
  const auto times = times_of(wish, result);
  const auto suffix = [&](std::size_t t) { return times.size() > 1 ? fmt::format("_{:05}", t) : std::string(); };
  const auto add_field = [&](const Entry& field) {
    for (const auto t : times) {
      pictures.push_back({fmt::format("field_{}{}{}.png", safe(field.name), wish.around ? "_around" : "", suffix(t)),
                          [&, t](const auto& png) {
                            if (wish.around)
                              plot_around(result, field, t, png);
                            else
                              plot_field(result, field, t, {wish.arrows}, png);
                          }});
    }
  };
  const auto add_observable = [&](const Entry& observable) {
    // A course shows all times at once.
    const auto records = observable.shape.empty() ? std::vector<std::size_t>{times.back()} : times;
    for (const auto t : records) {
      const auto name = fmt::format("observable_{}{}.png", safe(observable.name), records.size() > 1 ? suffix(t) : "");
      pictures.push_back({name, [&, t](const auto& png) { plot_observable(result, observable, t, png); }});
    }
  };
  if (!wish.field.empty()) add_field(result.field(wish.field));
  if (!wish.observable.empty()) add_observable(result.observable(wish.observable));
  if (!wish.field.empty() || !wish.observable.empty()) return pictures;
  for (const auto& field : result.fields) {
    const bool of_particles = !field.shape.empty() && field.shape[0] == result.material.size();
    if (of_particles && field.name != "position" && field.name != "volume") add_field(field);
  }
  for (const auto& observable : result.observables) add_observable(observable);
  return pictures;
}

void plot_result(const Wish& wish) {
  const ResultFile result(wish.result);
  if (result.done == 0)
    throw base::InputError(fmt::format("{} holds no finished realisation yet (status {})", wish.result, result.status));
  if (wish.around && wish.field.empty()) throw base::InputError("--around needs --field NAME");
  const auto pictures = pictures_of(wish, result);
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
