// shmoo merge PART.h5... -o ALL.h5: parts of one ensemble into one result.
#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "run/ensemble.hpp"
#include "run/merge.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::vector<std::string> parts;
  std::string output;
  bool force = false;
};

int merge(const Wish& wish, const Workshop& workshop) {
  const std::filesystem::path output = wish.output;
  require_writable(output);
  std::error_code ignored;
  if (!wish.force && std::filesystem::exists(output, ignored))
    throw base::InputError(fmt::format("{} exists; --force replaces it, -o OTHER.h5 leaves it", output.string()));
  std::vector<std::string> words{"shmoo", "merge"};
  words.insert(words.end(), wish.parts.begin(), wish.parts.end());
  words.insert(words.end(), {"-o", wish.output});
  const std::vector<std::filesystem::path> parts(wish.parts.begin(), wish.parts.end());
  const auto end = merge_results(parts, output, workshop, shell_line(words));
  fmt::print(stderr, "{}: {} of {} realisations\n", output.string(), end.done, end.wanted);
  return exit_done;
}

}  // namespace

void declare_merge(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("merge", "Join parts of one ensemble into one result, exactly");
  verb->add_option("PART.h5", wish->parts, "results of 'shmoo run MODEL --part I/K'")->required();
  verb->add_option("-o,--output", wish->output, "the result file")->required();
  verb->add_flag("--force", wish->force, "replace an existing result file");
  verb->callback([wish, &desk] { desk.exit_code = merge(*wish, desk.workshop); });
}

}  // namespace shmoo::run
