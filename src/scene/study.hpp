#pragma once
// What a study file says: which runs of a model to compare, what of them, and with what.
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "scene/read.hpp"

namespace shmoo::scene {

// A number that the study gives in SI, or that is read from the model as it is run: the path of one of its keys.
struct StudyNumber {
  double value = 0;
  std::string path{};  // "boundary.0.value"; empty: the value
  base::Dimension dimension{};
  base::Location where{};
};

enum class StudyNorm {
  rms,              // sqrt(mean e^2)
  root_sum_over_n,  // sqrt(sum e^2)/N: Eq. 2.31 of the thesis that the published tables of chemistry come from
  maximum,          // max |e|
};

struct StudyReference {
  enum class Type { formula, table, method, value } type = Type::value;
  std::string formula;                  // of base::exact_solutions()
  std::vector<StudyNumber> parameters;  // in the formula's order
  std::vector<std::string> tables;      // one for all levels, or one per level; paths
  std::string column;                   // of a table; its first column is x [m], or t [s] of a scalar
  std::optional<std::size_t> method;    // none: the one that is compared
  bool finest = false;                  // at the last level, else at the same
  std::optional<StudyNumber> value;     // the value itself; of a table: what its column is multiplied by
};

struct StudyQuantity {
  std::string name;
  std::string field, observable;                     // one of them
  std::size_t component = 0;                         // of a vector field
  std::size_t axis = 0;                              // along which a profile runs
  std::vector<double> times;                         // [s]; empty: the last record
  std::optional<std::array<double, 2>> average;      // [s]: the mean over the records in between
  std::optional<std::array<double, 2>> amplitude{};  // [s]: half of what lies between its extremes in between
  std::optional<std::array<double, 2>> period{};     // [s]: the first period of the course in between
  // [s]: amplitude or period of the strongest oscillation in between
  std::optional<std::array<double, 2>> harmonic{}, harmonic_period{};
  ShapePointer region;                               // null: everywhere
  StudyReference reference;
  StudyNorm norm = StudyNorm::rms, published_norm = StudyNorm::rms;
  std::optional<StudyNumber> scale;                      // errors are divided by it
  bool relative = false;                                 // errors are divided by the reference, place by place
  std::map<std::string, std::vector<double>> published;  // by method: one figure per level
};

struct StudyLevel {
  std::string name;
  Overrides set;
};

struct StudyMethod : StudyLevel {
  std::optional<std::size_t> realisations;  // in place of the model's
  std::vector<bool> levels{};               // at which it is run
  std::size_t repeats = 1;                  // ensembles with seeds of their own
  std::optional<std::size_t> mean_of;       // the method whose solution its exact mean is compared with
};

struct Study {
  std::string title, regime, name;  // name: of its files
  std::string file, model;          // paths
  std::string resolution;           // path of a key of the model, or a derived number of the result
  double budget = 0;                // CPU time of one run [s]
  std::vector<double> wanted;       // accuracies
  std::vector<StudyQuantity> quantities;
  std::vector<StudyMethod> methods;
  std::vector<StudyLevel> levels;
};

// Throws base::InputError with every mistake of the file at once, or those of its model.
Study read_study(const std::string& file);
Study read_study_text(const std::string& text, const std::string& file);  // `file`: where it stands

// A value of a model's text by its path ("domain.size.0"), SI. Throws std::runtime_error that says why there is none.
base::Measured number_in_model(const std::string& text, const std::string& path);

std::string study_json_schema();
std::string study_key_reference();

}  // namespace shmoo::scene
