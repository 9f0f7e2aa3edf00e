// shmoo verify [SUITE]: runs cases that are judged by laws, and says which hold.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/clock.hpp"
#include "base/error.hpp"
#include "run/verbs/verbs.hpp"
#include "run/verify/case.hpp"

namespace shmoo::run {
namespace {

struct Wish {
  std::string suite, seed;
  std::vector<std::string> cases;
  bool list = false, json = false;
};

struct Verdict {
  std::vector<verify::Finding> findings;
  std::string failure;  // what was thrown, where something was
  double cpu = 0;       // [s]
  bool holds() const {
    return failure.empty() && std::all_of(findings.begin(), findings.end(), [](const auto& f) { return f.holds(); });
  }
};

std::vector<verify::Case> cases_of(const Wish& wish) {
  const bool both = wish.suite.empty();
  if (!both && wish.suite != "stability" && wish.suite != "chemistry")
    throw base::InputError(fmt::format("there is no suite '{}'; the suites are: chemistry, stability", wish.suite));
  const auto seed = wish.seed.empty() ? 1 : whole_number("--seed", wish.seed, 0, ~std::uint64_t{0} >> 1);
  std::vector<verify::Case> all;
  if (both || wish.suite == "chemistry") all = verify::chemistry_cases(seed);
  if (both || wish.suite == "stability")
    for (auto& one : verify::stability_cases()) all.push_back(std::move(one));
  return all;
}

std::vector<verify::Case> wanted(const Wish& wish) {
  auto all = cases_of(wish);
  if (wish.cases.empty()) {
    if (!wish.list) std::erase_if(all, [](const auto& one) { return one.by_name_only; });
    return all;
  }
  std::vector<verify::Case> some;
  for (const auto& name : wish.cases) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    if (found == all.end()) {
      std::string names;
      for (const auto& one : all) names += (names.empty() ? "" : ", ") + one.name;
      throw base::InputError(fmt::format("there is no case '{}'; the cases are: {}", name, names));
    }
    some.push_back(*found);
  }
  return some;
}

Verdict judge(const verify::Case& one) {
  Verdict verdict;
  const double start = base::cpu_seconds();
  try {
    verdict.findings = one.run();
  } catch (const std::exception& error) {
    verdict.failure = error.what();
  }
  verdict.cpu = base::cpu_seconds() - start;
  return verdict;
}

std::string allowed(const verify::Finding& finding) {
  if (finding.lowest == finding.highest) return fmt::format("= {:g}", finding.highest);
  if (!std::isfinite(finding.lowest)) return fmt::format("<= {:g}", finding.highest);
  if (!std::isfinite(finding.highest)) return fmt::format(">= {:g}", finding.lowest);
  return fmt::format("{:g} .. {:g}", finding.lowest, finding.highest);
}

void print(const verify::Case& one, const Verdict& verdict) {
  fmt::print("{:<6} {}: {} ({:.1f} CPU s)\n", verdict.holds() ? "holds" : "BROKEN", one.name, one.what, verdict.cpu);
  if (!verdict.failure.empty()) fmt::print("       stopped by: {}\n", verdict.failure);
  for (const auto& f : verdict.findings)
    fmt::print("  {}  {:<60} {:>12.4g}   {}\n", f.holds() ? "    " : "!!!!", f.law, f.value, allowed(f));
  std::fflush(stdout);
}

void print_json(const verify::Case& one, const Verdict& verdict) {
  nlohmann::json line = {{"case", one.name}, {"holds", verdict.holds()}, {"cpu_seconds", verdict.cpu}};
  if (!verdict.failure.empty()) line["failure"] = verdict.failure;
  for (const auto& f : verdict.findings)
    line["laws"].push_back({{"law", f.law},
                            {"value", f.value},
                            {"allowed", allowed(f)},
                            {"holds", f.holds()},
                            {"false_alarm", f.false_alarm}});
  fmt::print("{}\n", line.dump());
}

int run_suite(const Wish& wish) {
  const auto cases = wanted(wish);
  std::size_t broken = 0, laws = 0;
  double false_alarm = 0.0;
  for (const auto& one : cases) {
    if (wish.list) {
      fmt::print("{:<20} {}\n", one.name, one.what);
      continue;
    }
    const auto verdict = judge(one);
    wish.json ? print_json(one, verdict) : print(one, verdict);
    broken += !verdict.holds();
    laws += verdict.findings.size();
    for (const auto& finding : verdict.findings) false_alarm += finding.false_alarm;
  }
  if (!wish.list && !wish.json)
    fmt::print("{} of {} cases hold, {} laws; a right program breaks one with a chance of at most {:.2g}\n",
               cases.size() - broken, cases.size(), laws, false_alarm);
  return broken == 0 ? exit_done : exit_failed;
}

}  // namespace

void declare_verify(CLI::App& app, Desk& desk) {
  auto wish = std::make_shared<Wish>();
  auto* verb = app.add_subcommand("verify", "Run cases that are judged by laws, on this machine");
  verb->add_option("SUITE", wish->suite,
                   "chemistry: every sampler against exact laws; stability: hard cases, run to a long time [both]");
  verb->add_option("--seed", wish->seed, "of the random numbers of chemistry [1]");
  verb->add_option("--case", wish->cases, "only this case; may be repeated")
      ->take_all()
      ->expected(1)
      ->allow_extra_args(false);
  verb->add_flag("--list", wish->list, "name the cases instead");
  verb->add_flag("--json", wish->json, "one object a line");
  verb->callback([wish, &desk] { desk.exit_code = run_suite(*wish); });
}

}  // namespace shmoo::run
