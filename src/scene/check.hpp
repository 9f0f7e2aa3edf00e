#pragma once
// Checks a parsed file against the schema's table: unknown and missing keys, types, units, ranges, names from fixed
// lists.
#include <toml++/toml.h>

#include <string>

#include "scene/report.hpp"
#include "scene/schema.hpp"

namespace shmoo::scene {

inline constexpr int deepest_shape = 32;  // shapes inside shapes

class Checker {
 public:
  // dimension: of the scene, 0 where it is not known. `well`: the scene is well mixed.
  Checker(Report& report, int dimension, bool well = false) : report_(report), dimension_(dimension), well_(well) {}

  void check_table(const toml::table& given, const Table& schema, const std::string& path);

 private:
  const ShapeTable* shape_of(const toml::table& given, const Table& schema, const std::string& path);
  void check_keys(const toml::table& given, const Table& schema, const ShapeTable* shape, const std::string& path);
  void unknown_key(const toml::key& key, const toml::node& value, const Table& schema, const ShapeTable* shape,
                   const std::string& path, std::vector<std::string>& meant);
  void check_required(const toml::table& given, const Key& key, const std::string& path,
                      const std::vector<std::string>& meant);
  bool check_value(const toml::node& value, const std::vector<Form>& forms, const std::string& path);
  bool check_string(const toml::node& value, const std::string& text, const std::vector<Form>& forms,
                    const std::string& path);
  bool check_choice(const toml::node& value, const std::string& text, const Form& form, const std::vector<Form>& forms,
                    const std::string& path);
  bool check_quantity(const toml::node& value, const std::string& text, const Form& form, const std::string& path);
  bool check_number(const toml::node& value, const std::vector<Form>& forms, const std::string& path);
  bool check_list(const toml::node& value, const Form& form, const std::string& path);
  bool check_named(const toml::table& given, const Form& form, const std::string& path);
  bool known_here(const Key& key) const { return key.place != (well_ ? Place::space : Place::well); }
  std::vector<std::string> key_names(const Table& schema, const ShapeTable* shape) const;
  bool wrong(const toml::node& value, const std::vector<Form>& forms, const std::string& path);
  bool fail(const toml::node& value, const std::string& path, const std::string& message);

  Report& report_;
  int dimension_;
  bool well_;
  int shape_depth_ = 0;
};

// "path.key", or "key" at the top of a file.
std::string join_path(const std::string& path, std::string_view key);

// True where the text of a value that may be a quantity or a formula is meant as a quantity: a number followed by a
// unit.
bool looks_like_quantity(std::string_view text);

// What came, for a message: "the number 4", "a list".
std::string describe(const toml::node& value);

}  // namespace shmoo::scene
