#pragma once
// One file per verb. Each declares its options and leaves what is to be done as the verb's callback.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "run/command_line.hpp"

namespace shmoo::run {

struct Desk {
  const Workshop& workshop;
  int exit_code = exit_done;  // a verb's callback sets it; errors are thrown
};

void declare_run(CLI::App& app, Desk& desk);
void declare_check(CLI::App& app, Desk& desk);
void declare_explain(CLI::App& app, Desk& desk);
void declare_info(CLI::App& app, Desk& desk);
void declare_merge(CLI::App& app, Desk& desk);
void declare_plot(CLI::App& app, Desk& desk);
void declare_report(CLI::App& app, Desk& desk);
void declare_import(CLI::App& app, Desk& desk);
void declare_export(CLI::App& app, Desk& desk);
void declare_schema(CLI::App& app, Desk& desk);
void declare_study(CLI::App& app, Desk& desk);
void declare_verify(CLI::App& app, Desk& desk);
void declare_bench(CLI::App& app, Desk& desk);

// A whole number in [lowest, highest], or a base::InputError that names the option.
std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t lowest,
                           std::uint64_t highest);

// "path=value" pairs, or a base::InputError.
scene::Overrides overrides_of(const std::vector<std::string>& settings);

// The words as one line that a shell reads back as the same words.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace shmoo::run
