#pragma once
// A result file as its readers see it: info, plots, exports.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "run/hdf5.hpp"

namespace shmoo::run {

struct Entry {  // a field or an observable
  std::string name, unit;
  bool varying = false;                  // has mean, variance and quantiles; otherwise one value
  std::vector<std::size_t> shape{};      // at one time
  std::vector<std::string> materials{};  // a field that lives in some only; empty: in all
  std::vector<double> probabilities{};   // of the quantiles
  std::vector<double> axis{};            // [m], profiles

  std::size_t cells() const;
};

// One quantity at one time; the last three are empty where it does not vary or fewer than two realisations are done.
struct Slice {
  std::vector<double> mean, deviation, error;
  std::vector<std::vector<double>> quantiles;
};

// An observable over all times: rows are times.
struct Course {
  Slice all;
  std::size_t realisations = 0;
  std::vector<double> values;
};  // values: [realisation][time][cell], done ones

class ResultFile {
 public:
  explicit ResultFile(const std::filesystem::path& path);  // base::InputError where it is no result file

  const std::filesystem::path& path() const { return path_; }
  hid_t id() const { return file_; }

  std::string title, status, message;
  std::uint64_t seed = 0;
  std::size_t realisations = 0, done = 0;
  int dimension = 2;
  bool axisymmetric = false;                                // turned about the x axis
  double spacing = 0, depth = 0;                            // [m]
  std::vector<double> lower, upper;                         // [m]
  std::vector<double> times;                                // [s]
  std::vector<std::int32_t> material;                       // by particle
  std::vector<std::string> material_names, material_types;  // "fluid", "wall", "still"
  std::vector<Entry> fields, observables;

  const Entry& field(const std::string& name) const;       // base::InputError with the nearest name
  const Entry& observable(const std::string& name) const;  // the same
  // x, y, z of every particle at a time: the recorded positions, or where it started.
  // Places that no particle has, in a domain with open sides, are no numbers.
  std::vector<double> positions(std::size_t time) const;
  Slice field_slice(const Entry& entry, std::size_t time) const;
  Course course(const Entry& entry) const;
  std::size_t nearest_time(double t) const;  // index

 private:
  Entry describe_field(const std::string& name) const;
  Entry describe_observable(const std::string& name) const;

  std::filesystem::path path_;
  h5::Handle file_;
};

}  // namespace shmoo::run
