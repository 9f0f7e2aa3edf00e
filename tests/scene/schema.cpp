// The schema's table: complete, and the same in the program, in the JSON Schema and in the reference.
#include "scene/schema.hpp"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "json_schema_validator.hpp"
#include "scene/document.hpp"
#include "scene/read.hpp"

namespace shmoo::scene {
namespace {

const std::filesystem::path data = SHMOO_SOURCE_DIR "/tests/data";

std::vector<std::filesystem::path> good_models() {
  std::vector<std::filesystem::path> files{data / "yeast-sketch.toml"};
  for (const auto& entry : std::filesystem::directory_iterator(data / "good-models")) files.push_back(entry.path());
  return files;
}

nlohmann::json json_of(const std::string& toml_text) {
  std::ostringstream stream;
  stream << toml::json_formatter(toml::parse(toml_text));
  return nlohmann::json::parse(stream.str());
}

// Notes every key of the table that a document uses, as "table.key", and the shapes as "shape.key".
void note_keys(const toml::table& given, const Table& schema, std::set<std::string>& used);

void note_value(const toml::node& value, const std::vector<Form>& forms, std::set<std::string>& used) {
  for (const Form& form : forms) {
    if (const auto* inner = value.as_table(); inner && form.kind == Kind::table)
      note_keys(*inner, table(form.table), used);
    if (const auto* inner = value.as_table(); inner && form.kind == Kind::named)
      for (const auto& [key, entry] : *inner) note_value(entry, form.element, used);
    if (const auto* list = value.as_array(); list && form.kind == Kind::list)
      for (const auto& entry : *list) note_value(entry, form.element, used);
  }
}

void note_keys(const toml::table& given, const Table& schema, std::set<std::string>& used) {
  const ShapeTable* shape = find_shape(given["shape"].value_or(std::string()));
  if (shape) used.insert("shape." + std::string(shape->name));
  for (const auto& [name, value] : given) {
    const Key* key = find_key(schema, name.str(), shape);
    if (!key) key = find_key(schema, "NAME");
    ASSERT_TRUE(key) << name.str();
    used.insert(std::string(schema.id) + "." + std::string(key->name));
    note_value(value, key->forms, used);
  }
}

TEST(Schema, EveryKeyIsUsedByAGoodModel) {
  std::set<std::string> used;
  for (const auto& file : good_models()) {
    EXPECT_NO_THROW(read_scene(file)) << file;
    note_keys(toml::parse(read_bytes(file)), table(""), used);
  }
  for (const Table& one : tables()) {
    for (const Key& key : one.keys) {
      if (key.forms.front().kind == Kind::refused) continue;
      EXPECT_TRUE(used.contains(std::string(one.id) + "." + std::string(key.name))) << one.title << " " << key.name;
    }
  }
  for (const ShapeTable& shape : shape_tables())
    EXPECT_TRUE(used.contains("shape." + std::string(shape.name))) << shape.name;
}

TEST(Schema, EveryKeyIsExplained) {
  for (const Table& one : tables()) {
    EXPECT_FALSE(one.doc.empty()) << one.id;
    for (const Key& key : one.keys) {
      EXPECT_FALSE(key.doc.empty()) << key.name;
      EXPECT_FALSE(key.forms.empty()) << key.name;
    }
  }
}

TEST(JsonSchema, AcceptsGoodModels) {
  const JsonSchemaValidator validator(nlohmann::json::parse(json_schema()));
  for (const auto& file : good_models()) EXPECT_TRUE(validator.valid(json_of(read_bytes(file)))) << file;
}

TEST(JsonSchema, RefusesWhatAnEditorCanSee) {
  const JsonSchemaValidator validator(nlohmann::json::parse(json_schema()));
  for (const char* kind : {"unknown-key",
                           "unknown-table",
                           "everything-missing",
                           "no-dimension",
                           "dimension-4",
                           "dimension-float",
                           "no-run",
                           "materials-as-list",
                           "bare-number",
                           "number-in-quotes-without-unit",
                           "unit-without-number",
                           "jitter-too-large",
                           "unknown-material-type",
                           "region-without-shape",
                           "unknown-shape",
                           "key-of-another-shape",
                           "empty-union",
                           "difference-of-one",
                           "initial-shape-key-without-shape",
                           "method-automatic",
                           "effects-default-true",
                           "sbml-network",
                           "boundary-unknown-type",
                           "unknown-kernel",
                           "courant-too-large",
                           "quantile-out-of-range",
                           "effect-as-number"}) {
    bool found = false;
    for (const auto& entry : std::filesystem::directory_iterator(data / "bad-models")) {
      const std::string stem = entry.path().stem();
      if (entry.path().extension() != ".toml" || stem.substr(4) != kind) continue;
      found = true;
      EXPECT_FALSE(validator.valid(json_of(read_bytes(entry.path())))) << entry.path();
    }
    EXPECT_TRUE(found) << kind;
  }
}

// With SHMOO_UPDATE_DOCS set in the environment the file is brought up to date instead.
TEST(Reference, InTheDocumentationIsUpToDate) {
  const std::string file = SHMOO_SOURCE_DIR "/docs/model-file.md";
  const std::string text = read_bytes(file);
  const std::string begin = "<!-- reference: begin -->\n", end = "<!-- reference: end -->\n";
  const auto from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::string wanted = text.substr(0, from + begin.size()) + key_reference() + text.substr(to);
  if (std::getenv("SHMOO_UPDATE_DOCS"))
    std::ofstream(file, std::ios::binary) << wanted;
  else
    EXPECT_TRUE(text == wanted) << "run this test with SHMOO_UPDATE_DOCS=1 to bring docs/model-file.md up to date";
}

// Every model that the documentation shows is a model.
TEST(Reference, ItsExamplesLoad) {
  const std::string text = read_bytes(SHMOO_SOURCE_DIR "/docs/model-file.md");
  const std::string fence = "```toml\n";
  int examples = 0;
  for (auto at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const auto begin = at + fence.size();
    const std::string model = text.substr(begin, text.find("```", begin) - begin);
    if (model.find("dimension =") == std::string::npos && model.find("[compartments.") == std::string::npos)
      continue;  // a part of one
    EXPECT_NO_THROW(read_scene_text(model, "example.toml")) << model;
    ++examples;
  }
  EXPECT_GE(examples, 2);
}

}  // namespace
}  // namespace shmoo::scene
