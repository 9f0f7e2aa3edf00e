// Studies as a user runs them: as processes, stopped and resumed, with runs that fail; and the parts of a random error
// on samples whose law is known.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <random>
#include <thread>

#include "run/study/ensemble_errors.hpp"
#include "run/study/needs.hpp"
#include "run/study/summary.hpp"
#include "run/study/tables.hpp"
#include "scratch.hpp"

namespace shmoo::run::study {
namespace {

// Diffusion in a slab, small enough for a test.
const std::string model = R"(dimension = 1
cross_section = "1 m^2"
[domain]
size = ["1 m"]
spacing = "0.1 m"
[materials.slab]
type = "still"
[species.C]
diffusivity = "0.1 m^2/s"
method = "deterministic"
[[boundary]]
species = "C"
at = "x_min"
type = "fixed"
value = "1000 molecules/m^3"
[[boundary]]
species = "C"
at = "x_max"
type = "absorb"
[numerics]
reach = 1.2
tolerance = 1e-8
[run]
until = "1 s"
record_every = "1 s"
realisations = 20
)";

const std::string study = R"(title = "Slab"
name = "slab"
model = "model.toml"
budget = "1 s"
wanted = [0.1]
[[method]]
name = "deterministic"
[[method]]
name = "sampled"
set = { "species.C.method" = "stochastic" }
mean_of = "deterministic"
repeats = 4
[[level]]
name = "coarse"
[[level]]
name = "fine"
set = { "domain.spacing" = "0.05 m" }
[[quantity]]
name = "profile"
field = "C"
scale = "boundary.0.value"
[quantity.reference]
formula = "slab_diffusion"
parameters = { length = "1 m", diffusivity = "species.C.diffusivity", concentration = "boundary.0.value" }
)";

class Studies : public ::testing::Test {
 protected:
  Studies() { write("model.toml", model); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(scratch / name) << text; }

  pid_t start(std::vector<std::string> words) const {
    words.insert(words.begin(), {SHMOO_PROGRAM, "study", (scratch / "study.toml").string(), "--quiet"});
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const auto out = (scratch / "out.txt").string();
    const pid_t child = fork();
    if (child == 0) {
      const int file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
      execv(argv[0], argv.data());
      _exit(127);
    }
    return child;
  }

  static int wait_for(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  int run(const std::string& folder, const std::string& extra = "--jobs=2") const {
    return wait_for(start({"-o", (scratch / folder).string(), extra}));
  }

  std::string printed() const {
    std::ifstream in(scratch / "out.txt");
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::size_t finished(const std::string& folder) const {
    std::size_t files = 0;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path() / folder / "points/slab", none))
      files += entry.path().extension() == ".toml";
    return files;
  }

  Scratch scratch;
};

TEST_F(Studies, MeasureErrorsOrdersAndChance) {
  write("study.toml", study);
  ASSERT_EQ(run("a"), 0) << printed();
  const auto summary = read_summary(scratch / "a/slab.toml");
  EXPECT_EQ(summary.runs, 10u);
  EXPECT_EQ(summary.failed, 0u);
  ASSERT_EQ(summary.verdicts.size(), 1u);
  const auto& rows = summary.verdicts[0].rows;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_NEAR(rows[1].order, 2.0, 0.3);
  EXPECT_LT(rows[1].error, 2e-3);
  EXPECT_GT(rows[0].cpu_seconds, 0.0);
  EXPECT_GT(rows[0].memory, 1e6);
  EXPECT_EQ(rows[2].repeats, 4u);
  EXPECT_EQ(rows[2].realisations, 20u);
  // Counts are Poisson: sqrt(mean (C/V)/N)/C0, C falling from C0 to 0 along the slab.
  EXPECT_NEAR(rows[2].predicted, std::sqrt(1000.0 * 0.45 / 0.1 / 20.0) / 1000.0, 0.3 * rows[2].predicted);
  EXPECT_NEAR(rows[2].measured / rows[2].predicted, 1.0, 0.6);  // 3 x 10 degrees of freedom: 13 % is one deviation
  EXPECT_TRUE(std::filesystem::exists(scratch / "a/slab-profile.png"));
  EXPECT_NE(printed().find("| sampled       | fine   | 20 "), std::string::npos) << printed();
}

// What of a table does not depend on how busy the machine was.
std::vector<std::vector<double>> figures(const std::filesystem::path& file) {
  std::vector<std::vector<double>> all;
  for (const auto& row : read_summary(file).verdicts.at(0).rows)
    all.push_back({row.error, row.random ? row.spread : 0, row.random ? row.predicted : 0,
                   row.random ? row.measured : 0, row.events, row.steps});
  return all;
}

TEST_F(Studies, StoppedHalfWayGoOnToTheSameTable) {
  write("study.toml", study);
  ASSERT_EQ(run("whole"), 0) << printed();
  const auto child = start({"-o", (scratch / "parts").string(), "--jobs=1"});
  while (finished("parts") < 4) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  EXPECT_EQ(wait_for(child), 128 + SIGKILL);
  const auto before = finished("parts");
  EXPECT_LT(before, 10u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "parts/slab.toml"));
  ASSERT_EQ(run("parts"), 0) << printed();
  EXPECT_EQ(finished("parts"), 10u);
  EXPECT_EQ(figures(scratch / "parts/slab.toml"), figures(scratch / "whole/slab.toml"));
  // Nothing is left to do: the table is the same to the last digit, costs and all.
  const auto table = printed();
  ASSERT_EQ(run("parts"), 0);
  EXPECT_EQ(printed(), table);
}

TEST_F(Studies, InterruptedOnesSayThatTheyGoOn) {
  write("study.toml", study);
  const auto child = start({"-o", (scratch / "a").string(), "--jobs=1"});
  while (finished("a") < 2) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGINT);
  EXPECT_EQ(wait_for(child), 130);
  EXPECT_NE(printed().find("keeps what is finished"), std::string::npos) << printed();
}

TEST_F(Studies, ContainFailures) {
  auto text = study;
  const std::string fine = "set = { \"domain.spacing\" = \"0.05 m\" }";
  text.replace(text.find(fine), fine.size(),
               "set = { \"domain.spacing\" = \"0.001 m\", \"run.realisations\" = 200000, \"run.until\" = \"100 s\" }");
  text.replace(text.find("repeats = 4"), 11, "repeats = 1");
  write("study.toml", text);
  ASSERT_EQ(run("a"), 0) << printed();
  const auto rows = read_summary(scratch / "a/slab.toml").verdicts.at(0).rows;
  EXPECT_TRUE(std::isfinite(rows[2].error));
  EXPECT_FALSE(std::isfinite(rows[3].error));
  EXPECT_NE(rows[3].failure.find("took more than the 1 s of CPU time"), std::string::npos) << rows[3].failure;
  EXPECT_NE(printed().find("* sampled at fine failed: took more"), std::string::npos) << printed();
}

TEST_F(Studies, RefuseWhatTheModelDoesNotHave) {
  auto text = study;
  text.replace(text.find("species.C.diffusivity"), 21, "species.C.difusivity");
  write("study.toml", text);
  EXPECT_EQ(run("a"), 1);
  EXPECT_NE(printed().find("study.toml:24:46: error: species.C.difusivity: the model does not set it; give a number"),
            std::string::npos)
      << printed();
  text = study;
  text.replace(text.find("0.05 m"), 6, "0.05 s");
  write("study.toml", text);
  EXPECT_EQ(run("a"), 1);
  EXPECT_NE(printed().find("a length [m], such as \"1 um\" (method deterministic, level fine)"), std::string::npos)
      << printed();
}

// Ensembles of N normal numbers at P places, with mean `bias` and standard deviation 1.
std::vector<Sample> ensembles(std::size_t repeats, std::size_t places, std::size_t realisations, double bias) {
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal(bias, 1.0 / std::sqrt(double(realisations)));
  std::vector<Sample> all(repeats);
  for (auto& sample : all)
    for (std::size_t i = 0; i < places; ++i) {
      for (auto* axis : {&sample.x, &sample.y, &sample.z, &sample.t}) axis->push_back(double(i));
      sample.value.push_back(normal(generator));
      sample.variance.push_back(1.0);
    }
  return all;
}

Row statistics(const std::vector<Sample>& samples, std::size_t realisations, const Counterpart& counterpart) {
  Repeats repeats{.realisations = realisations};
  for (const auto& sample : samples) repeats.samples.push_back(&sample);
  repeats.reference.assign(samples.front().size(), 0.0);
  repeats.weight.assign(samples.front().size(), 0.5);
  Row row;
  fill_statistics(repeats, counterpart, row);
  return row;
}

TEST(ErrorOfAMean, SplitsIntoChanceAndBias) {
  const std::size_t places = 1000, repeats = 8, realisations = 100;
  const Counterpart zero{.mean = std::vector<double>(places, 0.0), .statistical = 0.0, .error = 0.25};
  const auto honest = statistics(ensembles(repeats, places, realisations, 0.0), realisations, zero);
  EXPECT_NEAR(honest.predicted, 0.05, 1e-12);
  EXPECT_NEAR(honest.measured, 0.05, 0.05 * 5 / std::sqrt(2.0 * 7 * places));  // five deviations
  EXPECT_LT(honest.bias, honest.bias_seen_from);
  EXPECT_EQ(honest.systematic, 0.25);  // that of the method which it agrees with
  const auto off = statistics(ensembles(repeats, places, realisations, 0.1), realisations, zero);
  EXPECT_NEAR(off.bias, 0.05, 0.003);
  EXPECT_GT(off.bias, off.bias_seen_from);
  EXPECT_NEAR(off.systematic, 0.05, 0.003);
}

TEST(ErrorOfAMean, TellsWhatAnAccuracyCosts) {
  scene::Study plan;
  plan.wanted = {0.1, 0.05, 0.01};
  plan.methods.resize(1);
  plan.methods[0].name = "m";
  // chance 0.1 with 50 realisations of 2 s each, 10 s shared; 0.02 stays.
  Row row{.method = "m", .level = "l", .random = true, .realisations = 50};
  row.error = 0.102, row.predicted = 0.1, row.systematic = 0.02, row.cpu_seconds = 110, row.cpu_per_realisation = 2;
  const auto all = needs(plan, {row});
  ASSERT_EQ(all.size(), 2u);                                             // 0.01 cannot be had
  EXPECT_EQ(all[0].realisations, std::size_t(std::ceil(0.5 / 0.0096)));  // 50 0.1^2/(0.1^2 - 0.02^2)
  EXPECT_EQ(all[1].realisations, std::size_t(std::ceil(0.5 / 0.0021)));
  EXPECT_DOUBLE_EQ(all[1].cpu_seconds, 10.0 + 2.0 * double(all[1].realisations));
}

TEST(ErrorOfAMean, NormsAreThoseOfTheirNames) {
  const std::vector<double> errors{3, -4, 100}, weight{1, 1, 0};
  EXPECT_DOUBLE_EQ(norm_of(scene::StudyNorm::rms, errors, weight), std::sqrt(12.5));
  EXPECT_DOUBLE_EQ(norm_of(scene::StudyNorm::root_sum_over_n, errors, weight), 2.5);
  EXPECT_DOUBLE_EQ(norm_of(scene::StudyNorm::maximum, errors, weight), 4.0);
}

TEST(ParetoFront, HoldsWhatNothingBeats) {
  std::vector<Row> rows(4);
  const double cpu[] = {1, 2, 3, 3}, error[] = {0.5, 0.6, 0.1, unknown};
  for (std::size_t i = 0; i < 4; ++i) rows[i].cpu_seconds = cpu[i], rows[i].error = error[i];
  mark_pareto(rows);
  EXPECT_TRUE(rows[0].pareto);
  EXPECT_FALSE(rows[1].pareto);
  EXPECT_TRUE(rows[2].pareto);
  EXPECT_FALSE(rows[3].pareto);
}

}  // namespace
}  // namespace shmoo::run::study
