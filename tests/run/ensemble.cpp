// Ensembles: the same bits for any number of threads and any division, and nothing lost when they end early.
#include "run/ensemble.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include "fake_experiment.hpp"
#include "run/hdf5.hpp"
#include "run/result_write.hpp"
#include "scratch.hpp"

namespace shmoo::run {
namespace {

EnsembleEnd run_fake(const std::filesystem::path& out, std::uint32_t n, int threads, bool resume = false) {
  FakeExperiment experiment;
  return run_ensemble(experiment,
                      {.output = out, .realisations = n, .threads = threads, .resume = resume, .write_interval = 0});
}

bool same(const std::filesystem::path& a, const std::filesystem::path& b) {
  const auto command = fmt::format("h5diff --exclude-path=/provenance '{}' '{}' >/dev/null", a.string(), b.string());
  return std::system(command.c_str()) == 0;
}

TEST(Ensemble, AnyNumberOfThreadsGivesTheSameFile) {
  const Scratch scratch;
  for (const int threads : {1, 2, 5}) run_fake(scratch / fmt::format("{}.h5", threads), 12, threads);
  EXPECT_TRUE(same(scratch / "1.h5", scratch / "2.h5"));
  EXPECT_TRUE(same(scratch / "1.h5", scratch / "5.h5"));
  run_fake(scratch / "fewer.h5", 11, 2);
  EXPECT_FALSE(same(scratch / "1.h5", scratch / "fewer.h5"));
}

TEST(Ensemble, HalvesMakeTheWhole) {
  const Scratch scratch;
  run_fake(scratch / "whole.h5", 10, 2);
  run_fake(scratch / "halves.h5", 4, 1);
  const auto end = run_fake(scratch / "halves.h5", 10, 3, true);
  EXPECT_EQ(end.done, 10u);
  EXPECT_TRUE(same(scratch / "whole.h5", scratch / "halves.h5"));
}

TEST(Ensemble, StatisticsAreThoseOfTheRealisations) {
  const Scratch scratch;
  run_fake(scratch / "a.h5", 9, 2);
  const FakeExperiment fake;
  const auto file = h5::open_for_reading(scratch / "a.h5");
  const auto mean = h5::read<double>(file, "/fields/L/mean"), variance = h5::read<double>(file, "/fields/L/variance");
  const auto amount = h5::read<double>(file, "/fields/D/mean"), median = h5::read<double>(file, "/fields/L/quantiles");
  const auto n = fake.particles(), records = fake.layout().times.size();
  for (std::size_t t = 0; t < records; ++t) {
    for (std::size_t i = 0; i < n; i += 5) {
      std::vector<double> sample;
      double sum = 0, squares = 0, real = 0;
      for (std::uint32_t k = 0; k < 9; ++k)
        sample.push_back(static_cast<double>(fake.count(k, t, i))), real += fake.amount(k, t, i) / 9;
      for (const auto x : sample) sum += x;
      for (const auto x : sample) squares += (x - sum / 9) * (x - sum / 9);
      std::sort(sample.begin(), sample.end());
      EXPECT_DOUBLE_EQ(mean[t * n + i], sum / 9);
      EXPECT_NEAR(variance[t * n + i], squares / 8, 1e-9);
      EXPECT_NEAR(amount[t * n + i], real, 50 * 1e-11);
      EXPECT_NEAR(median[(records + t) * n + i], sample[4], sample[4] / 128);  // the second of 0.05, 0.5, 0.95
    }
  }
  EXPECT_EQ(h5::read<std::int64_t>(file, "/ledger/L/total")[0], 90);
  EXPECT_EQ(h5::read<double>(file, "/ledger/D/total")[1], 9.0);  // 0.25 (0 + ... + 8)
  EXPECT_EQ(h5::get_text(file, "status"), "done");
  EXPECT_EQ(h5::read_text(file, "/model/text"), fake.scene().text);
}

TEST(Ensemble, OneRealisationIsItsOwnMean) {
  const Scratch scratch;
  run_fake(scratch / "one.h5", 1, 4);
  const FakeExperiment fake;
  const auto file = h5::open_for_reading(scratch / "one.h5");
  const auto mean = h5::read<double>(file, "/fields/L/mean"),
             values = h5::read<double>(file, "/observables/total_L/values");
  EXPECT_EQ(mean[fake.particles() + 3], static_cast<double>(fake.count(0, 1, 3)));
  EXPECT_EQ(values, h5::read<double>(file, "/observables/total_L/mean"));
  EXPECT_EQ(h5::read<double>(file, "/observables/energy/mean")[2], 2e-15);
}

TEST(Ensemble, AFailureKeepsWhatIsDoneAndCanGoOn) {
  const Scratch scratch;
  FakeExperiment failing;
  failing.before = [](std::uint32_t k) {
    if (k == 5) throw base::RunError("density below zero at t = 0.3 s");
  };
  const EnsembleOptions options{.output = scratch / "f.h5", .realisations = 8, .threads = 1};
  try {
    run_ensemble(failing, options);
    FAIL() << "no error";
  } catch (const base::RunError& error) {
    EXPECT_STREQ(error.what(), "realisation 5: density below zero at t = 0.3 s");
  }
  const auto glance = glance_at(scratch / "f.h5");
  EXPECT_EQ(glance.status, "failed");
  EXPECT_EQ(glance.done, 5u);
  run_fake(scratch / "f.h5", 8, 2, true);
  run_fake(scratch / "whole.h5", 8, 2);
  EXPECT_TRUE(same(scratch / "f.h5", scratch / "whole.h5"));
}

TEST(Ensemble, AnInterruptKeepsWhatIsDoneAndCanGoOn) {
  const Scratch scratch;
  FakeExperiment interrupted;
  interrupted.before = [](std::uint32_t k) {
    if (k == 4) std::raise(SIGINT), std::raise(SIGINT);
  };
  const auto end = run_ensemble(interrupted, {.output = scratch / "i.h5", .realisations = 9, .threads = 2});
  EXPECT_TRUE(end.interrupted);
  EXPECT_LT(end.done, 9u);
  EXPECT_GE(end.done, 3u);
  EXPECT_EQ(glance_at(scratch / "i.h5").status, "interrupted");
  EXPECT_FALSE(run_fake(scratch / "i.h5", 9, 3, true).interrupted);
  run_fake(scratch / "whole.h5", 9, 2);
  EXPECT_TRUE(same(scratch / "i.h5", scratch / "whole.h5"));
}

TEST(Ensemble, ResumingRefusesAnotherModelSeedOrFewerRealisations) {
  const Scratch scratch;
  run_fake(scratch / "a.h5", 3, 1);
  FakeExperiment other_model, other_seed, same_model;
  other_model.scene_.text += "# changed\n";
  other_seed.scene_.run.seed = 8;
  const auto message = [&](FakeExperiment& experiment, std::uint32_t n) -> std::string {
    try {
      run_ensemble(experiment, {.output = scratch / "a.h5", .realisations = n, .resume = true});
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message(other_model, 4).find("made from another model"), std::string::npos);
  EXPECT_NE(message(other_seed, 4).find("give --seed 7"), std::string::npos);
  EXPECT_NE(message(same_model, 2).find("holds 3 realisations"), std::string::npos);
  EXPECT_EQ(glance_at(scratch / "a.h5").done, 3u);
}

TEST(Ensemble, WhatIsNoNumberIsReportedAndNotSummed) {
  const Scratch scratch;
  FakeExperiment experiment;
  experiment.layout_.fields[2].scale = 1e-5;  // values of 50 lie beyond 2^15 of it
  try {
    run_ensemble(experiment, {.output = scratch / "x.h5", .realisations = 2});
    FAIL() << "no error";
  } catch (const base::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("field D at t = 0 s"), std::string::npos) << error.what();
  }
}

// Killed at random moments by a signal that cannot be caught, the file opens and every realisation in it is whole.
TEST(Ensemble, KilledAtAnyMomentLeavesAReadableFile) {
  const Scratch scratch;
  run_fake(scratch / "whole.h5", 60, 1);
  base::RandomSequence random({3, 0}, base::Stream::test);
  for (int trial = 0; trial < 12; ++trial) {
    const auto out = scratch / fmt::format("k{}.h5", trial);
    run_fake(out, 1, 1);
    const pid_t child = fork();
    if (child == 0) {
      FakeExperiment slow;
      slow.seconds_per_realisation = 0.002;
      run_ensemble(slow, {.output = out, .realisations = 60, .threads = 2, .resume = true, .write_interval = 0});
      _exit(0);
    }
    usleep(static_cast<useconds_t>(2000 + 400000 * random.uniform()));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    const auto glance = glance_at(out);
    EXPECT_GE(glance.done, 1u);
    run_fake(out, 60, 2, true);
    EXPECT_TRUE(same(out, scratch / "whole.h5")) << glance.status << " " << glance.done;
  }
}

TEST(Ensemble, PlacesThatCannotBeWrittenAreRefusedFirst) {
  const Scratch scratch;
  EXPECT_THROW(require_writable(scratch / "missing/out.h5"), base::InputError);
  EXPECT_THROW(require_writable(scratch.path()), base::InputError);
  EXPECT_THROW(require_writable("/proc/out.h5"), base::InputError);
  EXPECT_NO_THROW(require_writable(scratch / "out.h5"));
  EXPECT_FALSE(std::filesystem::exists(scratch / "out.h5"));
}

// A file that may not grow stands for a disk that fills up in the middle of an ensemble.
TEST(Ensemble, ADiskThatFillsUpKeepsTheLastGoodFile) {
  const Scratch scratch;
  run_fake(scratch / "d.h5", 3, 1);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{std::filesystem::file_size(scratch / "d.h5") - 2000, RLIM_INFINITY};
    setrlimit(RLIMIT_FSIZE, &limit);
    FakeExperiment experiment;
    try {
      run_ensemble(experiment, {.output = scratch / "d.h5", .realisations = 9, .resume = true, .write_interval = 0});
    } catch (const base::RunError& error) {
      _exit(std::string(error.what()).find("d.h5.part") != std::string::npos ? 7 : 8);
    }
    _exit(9);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(glance_at(scratch / "d.h5").done, 3u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "d.h5.part"));
}

TEST(Ensemble, AFullDiskIsAnErrorOfTheRun) {
  FakeExperiment experiment;
  try {
    run_ensemble(experiment, {.output = "/dev/full/x.h5", .realisations = 2});
    FAIL() << "no error";
  } catch (const base::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("/dev/full/x.h5"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace shmoo::run
