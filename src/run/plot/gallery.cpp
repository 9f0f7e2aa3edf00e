#include "run/plot/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "run/plot/plot.hpp"

namespace shmoo::run {
namespace {

std::string safe(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == '\\' || c == ' '; }, '_');
  return name;
}

std::string suffix(const std::vector<std::size_t>& times, std::size_t t) {
  return times.size() > 1 ? fmt::format("_{:05}", t) : std::string();
}

void add_field(const ResultFile& result, const GalleryChoice& choice, const Entry& field, std::vector<Picture>& all) {
  for (const auto t : choice.times) {
    const auto name =
        fmt::format("field_{}{}{}.png", safe(field.name), choice.around ? "_around" : "", suffix(choice.times, t));
    all.push_back({name, field.name, [&result, &field, around = choice.around, arrows = choice.arrows, t](auto& png) {
                     if (around)
                       plot_around(result, field, t, png);
                     else
                       plot_field(result, field, t, {arrows}, png);
                   }});
  }
}

// A course shows all times at once.
void add_observable(const ResultFile& result, const GalleryChoice& choice, const Entry& observable,
                    std::vector<Picture>& all) {
  const auto records = observable.shape.empty() ? std::vector<std::size_t>{choice.times.back()} : choice.times;
  for (const auto t : records) {
    all.push_back({fmt::format("observable_{}{}.png", safe(observable.name), suffix(records, t)), observable.name,
                   [&result, &observable, t](auto& png) { plot_observable(result, observable, t, png); }});
  }
}

bool worth_a_picture(const ResultFile& result, const Entry& field) {
  const bool of_particles = !field.shape.empty() && field.shape[0] == result.material.size();
  return of_particles && field.name != "position" && field.name != "volume";
}

}  // namespace

std::vector<Picture> gallery(const ResultFile& result, const GalleryChoice& choice) {
  std::vector<Picture> all;
  if (!choice.field.empty()) add_field(result, choice, result.field(choice.field), all);
  if (!choice.observable.empty()) add_observable(result, choice, result.observable(choice.observable), all);
  if (!choice.field.empty() || !choice.observable.empty()) return all;
  for (const auto& field : result.fields)
    if (worth_a_picture(result, field)) add_field(result, choice, field, all);
  for (const auto& observable : result.observables) add_observable(result, choice, observable, all);
  return all;
}

}  // namespace shmoo::run
