// The schema's table as Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/exact_solutions.hpp"
#include "scene/read.hpp"
#include "scene/schema.hpp"
#include "scene/study.hpp"

namespace shmoo::scene {
namespace {

// A bar would end a cell of the table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '|') escaped += '\\';
    escaped += character;
  }
  return escaped;
}

std::string form_text(const Form& form);

std::string forms_text(const std::vector<Form>& forms) {
  std::vector<std::string> each;
  for (const Form& form : forms) each.push_back(form_text(form));
  return fmt::format("{}", fmt::join(each, ", or "));
}

std::string form_text(const Form& form) {
  if (form.kind == Kind::table) return fmt::format("a table: {}", table(form.table).title);
  if (form.kind == Kind::named) return fmt::format("a table: {} = {}", form.what, forms_text(form.element));
  if (form.kind == Kind::list && form.element.front().kind == Kind::table)
    return fmt::format("a list of tables: {}", table(form.element.front().table).title);
  std::string text = expected(form);
  if (form.kind == Kind::quantity && form.range.limited())
    text += fmt::format(" ({})", allowed(form.range, form.dimension));
  return text;
}

std::string rows(const std::vector<Key>& keys) {
  std::string text = "| key | value | default | meaning |\n| --- | --- | --- | --- |\n";
  for (const Key& key : keys) {
    const bool refused = key.forms.front().kind == Kind::refused;
    const std::string fallback = key.required ? "required" : key.fallback.empty() ? "-" : std::string(key.fallback);
    text += fmt::format("| `{}` | {} | {} | {} |\n", key.name, refused ? "refused" : cell(forms_text(key.forms)),
                        cell(fallback), cell(key.doc));
  }
  return text;
}

std::string heading(const Table& table) { return fmt::format("\n### `{}`\n\n{}\n", table.title, table.doc); }

std::string table_text(const Table& table) {
  const bool whole = table.title == "the file";
  std::string text = whole ? fmt::format("### The top of the file\n\n{}\n", table.doc) : heading(table);
  if (!table.keys.empty()) text += fmt::format("\n{}", rows(table.keys));
  if (table.shape == ShapeUse::required) text += "\nBesides, `shape` and the keys of that shape.\n";
  if (table.shape == ShapeUse::optional)
    text += "\nBesides, where it is limited to a part of space, `shape` and the keys of that shape.\n";
  return text;
}

std::string shapes_text() {
  std::string text =
      "\n### Shapes\n\nA table that takes a shape says `shape = \"NAME\"` and, beside it, the keys of that shape. "
      "Boxes are half-open: the "
      "lower faces belong to them, the upper ones do not.\n";
  for (const ShapeTable& shape : shape_tables())
    text += fmt::format("\n#### `shape = \"{}\"`\n\nIn scenes of dimension {}.\n\n{}", shape.name,
                        fmt::join(shape.dimensions, ", "), rows(shape.keys));
  return text;
}

}  // namespace

std::string key_reference() {
  std::string text;
  for (const Table& table : tables()) text += table_text(table);
  return text + shapes_text();
}

std::string study_key_reference() {
  std::string text;
  for (const Table& table : study_tables()) text += table_text(table);
  text += "\n### Exact solutions\n\n| formula | what | parameters |\n| --- | --- | --- |\n";
  for (const auto& one : base::exact_solutions()) {
    std::vector<std::string> names;
    for (const auto& parameter : one.parameters)
      names.push_back(fmt::format("`{}` [{}]", parameter.name, base::si_unit(parameter.dimension)));
    text += fmt::format("| `{}` | {} [{}] | {} |\n", one.name, cell(one.doc), base::si_unit(one.dimension),
                        fmt::join(names, ", "));
  }
  return text;
}

}  // namespace shmoo::scene
