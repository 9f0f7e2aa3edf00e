// shmoo run MODEL: one realisation or an ensemble into one result file.
#include <fmt/format.h>
#include <omp.h>

#include <filesystem>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "base/exact.hpp"
#include "run/ensemble.hpp"
#include "run/result_write.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string model, output, realisations, seed, threads, part;
  std::vector<std::string> settings;
  bool resume = false, force = false, quiet = false;
};

std::filesystem::path output_of(const Wish& wish) {
  if (!wish.output.empty()) return wish.output;
  return std::filesystem::path(wish.model).stem().string() + ".h5";
}

// An output that holds finished realisations is never lost by accident. Returns what it holds, if anything.
std::optional<Glance> look_at_output(const std::filesystem::path& output, const Wish& wish) {
  require_writable(output);
  std::error_code ignored;
  if (!std::filesystem::exists(output, ignored) || wish.force) return {};
  std::optional<Glance> glance;
  std::string held = "it is no result of shmoo";
  try {
    glance = glance_at(output);
    held = fmt::format("{} of {} realisations of \"{}\", status {}", glance->done, glance->realisations, glance->title,
                       glance->status);
  } catch (const base::RunError& error) {
    if (wish.resume) throw base::InputError(fmt::format("cannot resume: {}", error.what()));
  }
  if (wish.resume || (glance && glance->done == 0)) return glance;
  throw base::InputError(fmt::format("{} exists ({}); --resume adds to it, --force replaces it, -o OTHER.h5 leaves it",
                                     output.string(), held));
}

std::string command_to_go_on(const Wish& wish, const std::filesystem::path& output, std::size_t realisations,
                             std::uint64_t seed) {
  std::vector<std::string> words{"shmoo", "run", wish.model, "-o", output.string(), "-n", std::to_string(realisations)};
  if (!wish.seed.empty()) words.insert(words.end(), {"--seed", std::to_string(seed)});
  if (!wish.threads.empty()) words.insert(words.end(), {"--threads", wish.threads});
  if (!wish.part.empty()) words.insert(words.end(), {"--part", wish.part});
  for (const auto& setting : wish.settings) words.insert(words.end(), {"--set", setting});
  words.emplace_back("--resume");
  return shell_line(words);
}

int finish(const EnsembleEnd& end, const Wish& wish, const std::filesystem::path& output, const std::string& go_on) {
  if (end.interrupted) {
    fmt::print(stderr, "interrupted: {} keeps {} finished realisations of {}; to go on:\n  {}\n", output.string(),
               end.done, end.wanted, go_on);
    return exit_interrupted;
  }
  if (!end.balanced) {
    throw base::RunError(fmt::format(
        "the ledger of molecules does not balance in some realisations; /realisations/balanced in {} says which",
        output.string()));
  }
  if (!wish.quiet) {
    fmt::print(stderr, "{}: {} realisation{} in {}\n", output.string(), end.done, end.done == 1 ? "" : "s",
               duration_text(end.seconds));
  }
  return exit_done;
}

struct Part {
  std::uint32_t number = 1, of = 1;
};

Part part_of(const std::string& text) {
  if (text.empty()) return {};
  const auto slash = std::min(text.find('/'), text.size());
  const auto of = slash < text.size() ? text.substr(slash + 1) : std::string();
  if (of.empty())
    throw base::InputError(fmt::format("--part {}: give I/K, the number of this part and of all, like 2/4", text));
  Part part;
  part.of = static_cast<std::uint32_t>(whole_number("--part I/K: K", of, 1, base::sample_limit));
  part.number = static_cast<std::uint32_t>(whole_number("--part I/K: I", text.substr(0, slash), 1, part.of));
  return part;
}

int run_model(const Wish& wish, const Workshop& workshop) {
  const auto output = output_of(wish);
  auto scene = workshop.read(wish.model, overrides_of(wish.settings));
  if (!wish.seed.empty())
    scene.run.seed = whole_number("--seed", wish.seed, 0, std::numeric_limits<std::uint64_t>::max());
  const int threads =
      wish.threads.empty() ? omp_get_max_threads() : static_cast<int>(whole_number("--threads", wish.threads, 1, 4096));
  auto realisations = static_cast<std::uint64_t>(scene.run.realisations);
  if (!wish.realisations.empty()) realisations = whole_number("-n", wish.realisations, 1, base::sample_limit);
  const auto part = part_of(wish.part);
  const auto held = look_at_output(output, wish);
  if (wish.resume && held && wish.realisations.empty()) realisations = held->realisations;
  const auto seed = scene.run.seed;
  scene.run.realisations = static_cast<int>(realisations);

  const auto experiment = workshop.make(std::move(scene));
  if (!wish.quiet)
    for (const auto& note : experiment->notes()) fmt::print(stderr, "{}\n", note);
  const auto go_on = command_to_go_on(wish, output, realisations, seed);
  const EnsembleOptions options{.output = output,
                                .realisations = static_cast<std::uint32_t>(realisations),
                                .threads = threads,
                                .part = part.number - 1,
                                .parts = part.of,
                                .resume = wish.resume && held,
                                .progress = ProgressBar::style_for(wish.quiet),
                                .command = go_on};
  try {
    return finish(run_ensemble(*experiment, options), wish, output, go_on);
  } catch (const base::RunError& error) {
    std::string last;
    try {
      const auto glance = glance_at(output);
      last = fmt::format("\n{} keeps {} finished realisations of {}; once the cause is gone, go on with:\n  {}",
                         output.string(), glance.done, glance.realisations, go_on);
    } catch (const std::exception&) {
      last = fmt::format("\n{} could not be written: nothing was kept", output.string());
    }
    throw base::RunError(error.what() + last);
  }
}

}  // namespace

void declare_run(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("run", "Run a model into a result file: one realisation or an ensemble");
  verb->add_option("MODEL", wish->model, "the model file (TOML)")->required();
  verb->add_option("-o,--output", wish->output, "the result file [the model's name with .h5, in the current folder]");
  verb->add_option("-n,--realisations", wish->realisations, "how many realisations [what the model says]");
  verb->add_option("--seed", wish->seed, "seed of all random numbers [what the model says]");
  verb->add_option("--part", wish->part,
                   "I/K: only every K-th realisation, from the I-th on; 'shmoo merge' joins parts");
  verb->add_option("--threads", wish->threads, "threads to use [all]; never changes a result");
  verb->add_option("--set", wish->settings, "path=value: replace a value of the model; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->add_flag("--resume", wish->resume, "go on from the finished realisations in the result file");
  verb->add_flag("--force", wish->force, "replace an existing result file");
  verb->add_flag("--quiet", wish->quiet, "no progress on stderr");
  verb->callback([wish, &desk] { desk.exit_code = run_model(*wish, desk.workshop); });
}

}  // namespace shmoo::run
