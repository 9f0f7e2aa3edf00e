#pragma once
// The one table of the model file: every key with its kind, dimension, range, names, default and a line of explanation.
// It checks files (check.hpp), writes the JSON Schema (json_schema.cpp) and the reference (key_reference.cpp).
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.hpp"

namespace shmoo::scene {

struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool open_lower = false, open_upper = false;  // the bound itself is not allowed

  bool holds(double value) const {
    return (open_lower ? value > lower : value >= lower) && (open_upper ? value < upper : value <= upper);
  }
  bool limited() const {
    return lower > -std::numeric_limits<double>::infinity() || upper < std::numeric_limits<double>::infinity();
  }
};

// What a value may be.
enum class Kind {
  boolean,
  integer,
  number,
  text,        // any text
  choice,      // one of `choices`
  quantity,    // number and unit, of `dimension` within `range` (SI)
  unit_later,  // number and unit whose dimension another key decides
  expression,  // a formula
  list,        // of `element`s
  table,       // with the keys of `table`
  named,       // a table whose keys are names that the user gives and whose values are `element`s
  refused,     // not in this version; the key's doc says so
};

struct Form {
  Kind kind;
  base::Dimension dimension{};
  Range range{};
  std::vector<std::string_view> choices{};
  std::vector<Form> element{};                                            // any of these
  std::size_t least = 0, most = std::numeric_limits<std::size_t>::max();  // entries of a list
  bool per_axis = false;                                                  // as many entries as the scene has dimensions
  std::string_view table{};                                               // id
  std::string_view what{};  // what a text, unit_later or named stands for: "the name of a material"
};

// Which scenes know a key.
enum class Place { anywhere, space, well };  // well: a well-mixed scene, which has compartments and no domain

struct Key {
  std::string_view name;
  std::vector<Form> forms;  // the value may be any of these; their TOML types differ, or are told apart by their looks
  bool required = false;
  std::string_view fallback{};  // the default as the reference shows it
  std::string_view doc;
  Place place = Place::anywhere;
};

enum class ShapeUse { none, optional, required };

struct Table {
  std::string_view id;     // "" (the file), "domain", "material", ...
  std::string_view title;  // as written in a file: "[domain]", "[materials.NAME]"
  std::string_view doc;
  std::vector<Key> keys;
  ShapeUse shape = ShapeUse::none;  // takes the key `shape` and the keys of that shape besides
};

struct ShapeTable {
  std::string_view name;        // "box"
  std::vector<int> dimensions;  // of the scenes that know it
  std::vector<Key> keys;
};

const std::vector<Table>& tables();        // of model files, in the order of the reference
const std::vector<Table>& study_tables();  // of study files
const Table& table(std::string_view id);   // of either
const std::vector<ShapeTable>& shape_tables();
const ShapeTable* find_shape(std::string_view name);
const Key& shape_key();  // `shape` itself

// The key of that name in a table, or null. `shape`: the table's shape where it has one.
const Key* find_key(const Table& table, std::string_view name, const ShapeTable* shape = nullptr);

// "a length, such as "1 um"", "a list of 2 integers", ... for messages and the reference.
std::string expected(const Form& form, int dimension = 0);
std::string expected(const std::vector<Form>& forms, int dimension = 0);

// "> 0 m", "0 .. 1": the allowed range with its unit.
std::string allowed(const Range& range, const base::Dimension& dimension);

}  // namespace shmoo::scene
