#include "run/page/html.hpp"

#include <fmt/format.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace shmoo::run::html {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2rem; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; font-size: 0.9rem; } th, td { padding: 0.2rem 0.8rem 0.2rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #999; } table.numbers td + td, table.numbers th + th { text-align: right; }
td { font-variant-numeric: tabular-nums; } pre { background: #f5f5f5; padding: 1rem; overflow-x: auto; font-size: 0.85rem; }
figure { margin: 1rem 0; } img { max-width: 100%; } figcaption { font-size: 0.9rem; color: #555; }
.warning { color: #a00; font-weight: bold; })";

std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Digits(bytes.begin()), Digits(bytes.end()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::string cells(const Row& row, const char* tag) {
  std::string text = "<tr>";
  for (const auto& cell : row) text += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
  return text + "</tr>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string table(const Row& head, const std::vector<Row>& rows, bool numbers) {
  std::string text = numbers ? "<table class=\"numbers\">\n" : "<table>\n";
  if (!head.empty()) text += cells(head, "th");
  for (const auto& row : rows) text += cells(row, "td");
  return text + "</table>\n";
}

std::string image(const std::filesystem::path& png, const std::string& caption) {
  std::ifstream in(png, std::ios::binary);
  if (!in) throw base::RunError(fmt::format("cannot read the picture {}", png.string()));
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\">\n<figcaption>{0}</figcaption></figure>\n",
      escaped(caption), base64(bytes));
}

std::string document(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
      "<style>{1}</style></head>\n<body>\n<h1>{0}</h1>\n{2}</body></html>\n",
      escaped(title), style, body);
}

}  // namespace shmoo::run::html
