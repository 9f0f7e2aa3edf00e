// shmoo report OUT.h5: a page that needs no other file.
#include <fmt/format.h>

#include <fstream>

#include "base/error.hpp"
#include "run/page/page.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

void write_report(const std::string& path, std::string output) {
  const ResultFile result(path);
  if (result.done == 0)
    throw base::InputError(fmt::format("{} holds no finished realisation yet (status {})", path, result.status));
  if (result.times.empty()) throw base::InputError(fmt::format("{} holds no records", path));
  if (output.empty()) output = std::filesystem::path(path).replace_extension(".html").string();
  const auto page = result_page(result, result.times.size() - 1);
  std::ofstream out(output, std::ios::binary);
  out << page << std::flush;
  if (!out) throw base::InputError(fmt::format("cannot write {}; name a file in a folder that exists", output));
  fmt::print("{}\n", output);
}

}  // namespace

void declare_report(CLI::App& app, Desk&) {
  struct Wish {
    std::string result, output;
  };
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("report", "Write a result as one self-contained page: numbers, pictures, model");
  verb->add_option("OUT.h5", wish->result, "a result of 'shmoo run'")->required();
  verb->add_option("-o,--output", wish->output, "the page [OUT.html]");
  verb->callback([wish] { write_report(wish->result, wish->output); });
}

}  // namespace shmoo::run
