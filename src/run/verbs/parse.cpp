// Reads the command line, calls the verb and turns every error into a message and an exit code.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <span>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "run/description.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

using Words = std::span<const std::string>;

std::vector<std::string> verb_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& verb) {
  std::vector<std::string> names;
  for (const auto* option : verb.get_options()) {
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

bool is_number(const std::string& word) {
  return word.size() > 1 && word.find_first_not_of("0123456789.eE+-") == std::string::npos;
}

// Misspelt verbs and options, before anything else is looked at.
void require_known_words(const CLI::App& app, Words words) {
  if (words.empty())
    throw base::InputError(
        fmt::format("no verb given; allowed: {}\n(shmoo --help says more)", base::list_of(verb_names(app))));
  const auto verbs = verb_names(app);
  const auto& first = words.front();
  if (first.starts_with("-")) {
    const auto names = option_names(app);
    if (std::find(names.begin(), names.end(), first) != names.end()) return;
    throw base::InputError(fmt::format("unknown option '{}'{}; allowed before a verb: {}", first,
                                       base::did_you_mean(first, names), base::list_of(names)));
  }
  if (std::find(verbs.begin(), verbs.end(), first) == verbs.end()) {
    throw base::InputError(
        fmt::format("unknown verb '{}'{}; allowed: {}", first, base::did_you_mean(first, verbs), base::list_of(verbs)));
  }
  const auto names = option_names(*app.get_subcommand(first));
  for (const auto& word : words.subspan(1)) {
    if (word == "--") return;
    if (!word.starts_with("-") || word == "-" || is_number(word)) continue;
    const auto name = word.starts_with("--") ? word.substr(0, word.find('=')) : word.substr(0, 2);
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    throw base::InputError(fmt::format("unknown option '{}' of 'shmoo {}'{}; allowed: {}", name, first,
                                       base::did_you_mean(name, names), base::list_of(names)));
  }
}

void print_error(const std::string& text) {
  const bool labelled = text.find("error: ") != std::string::npos;
  fmt::print(stderr, "{}{}\n", labelled ? "" : "error: ", text);
}

int parse_and_call(CLI::App& app, Desk& desk, int argc, const char* const* argv) {
  const std::vector<std::string> words(argv + std::min(1, argc), argv + argc);
  require_known_words(app, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& wish) {  // help or version
    return app.exit(wish);
  } catch (const CLI::ParseError& error) {
    throw base::InputError(fmt::format("{}\n(shmoo {} --help says more)", error.what(), words.front()));
  }
  return desk.exit_code;
}

}  // namespace

int command_line(int argc, const char* const* argv, const Workshop& workshop) {
  try {
    Desk desk{workshop};
    CLI::App app("Shmoo: stochastic chemistry on the moving particles of a fluctuating fluid.", "shmoo");
    app.set_version_flag("--version",
                         fmt::format("shmoo {} ({}, {})", build().version, build().revision, build().compiler));
    app.require_subcommand(1);
    for (const auto declare :
         {declare_run, declare_check, declare_explain, declare_info, declare_merge, declare_plot, declare_report,
          declare_import, declare_export, declare_schema, declare_study, declare_verify, declare_bench})
      declare(app, desk);
    return parse_and_call(app, desk, argc, argv);
  } catch (const base::InputError& error) {
    print_error(error.what());
    return exit_input;
  } catch (const std::bad_alloc&) {
    print_error("not enough memory");
    return exit_failed;
  } catch (const std::exception& error) {
    print_error(error.what());
    return exit_failed;
  }
}

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < lowest || value > highest) {
    throw base::InputError(
        fmt::format("{} is '{}'; a whole number from {} to {} is needed", option, text, lowest, highest));
  }
  return value;
}

scene::Overrides overrides_of(const std::vector<std::string>& settings) {
  scene::Overrides overrides;
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw base::InputError(
          fmt::format("--set is '{}'; path=value is needed, as in --set 'domain.spacing=\"1 um\"'", setting));
    }
    overrides.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return overrides;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const auto& word : words) {
    if (!line.empty()) line += ' ';
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                            "_-./=:,+@%") == std::string::npos;
    if (plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace shmoo::run
