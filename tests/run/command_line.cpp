// Verbs, messages and exit codes, called in-process with an experiment of known numbers.
#include "run/command_line.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "fake_experiment.hpp"
#include "run/result_write.hpp"
#include "scratch.hpp"

namespace shmoo::run {
namespace {

struct Answer {
  int code;
  std::string out, err;
};

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    workshop.read = [](const std::string& file, const scene::Overrides& overrides) {
      if (file == "bad.toml")
        throw base::InputError({{{file, 3, 7}, "unknown key 'spacng'"}, {{file, 9, 1}, "no unit"}});
      auto scene = FakeExperiment().scene();
      for (const auto& [path, value] : overrides) scene.text += "# " + path + " = " + value + "\n";
      return scene;
    };
    workshop.read_text = [](const std::string& text, const std::string&) {
      auto scene = FakeExperiment().scene();
      scene.text = text;
      return scene;
    };
    workshop.make = [this](scene::Scene scene) {
      auto experiment = std::make_unique<FakeExperiment>();
      experiment->scene_ = std::move(scene);
      experiment->before = before;
      return experiment;
    };
    workshop.schema = [] { return std::string("{\"$schema\": \"x\"}"); };
  }

  Answer call(std::vector<std::string> words) const {
    words.insert(words.begin(), "shmoo");
    std::vector<const char*> argv;
    for (const auto& word : words) argv.push_back(word.c_str());
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    Answer answer;
    answer.code = command_line(static_cast<int>(argv.size()), argv.data(), workshop);
    std::fflush(nullptr);
    answer.out = ::testing::internal::GetCapturedStdout();
    answer.err = ::testing::internal::GetCapturedStderr();
    return answer;
  }

  void expect_error(const std::vector<std::string>& words, const std::string& part, int code = exit_input) const {
    const auto answer = call(words);
    EXPECT_EQ(answer.code, code) << answer.err;
    EXPECT_NE(answer.err.find(part), std::string::npos) << "wanted: " << part << "\ncame: " << answer.err;
    EXPECT_NE(answer.err.find("error: "), std::string::npos);
  }

  std::string out(const std::string& name = "out.h5") const { return (scratch / name).string(); }

  Scratch scratch;
  Workshop workshop;
  std::function<void(std::uint32_t)> before;
};

TEST_F(CommandLine, MistakesNameWhatCameAndWhatIsAllowed) {
  expect_error({}, "no verb given; allowed: run, check, explain, info");
  expect_error({"rnu", "m.toml"}, "unknown verb 'rnu'; did you mean 'run'?");
  expect_error({"--vresion"}, "did you mean '--version'?");
  expect_error({"run", "m.toml", "--thread", "3"},
               "unknown option '--thread' of 'shmoo run'; did you mean '--threads'?");
  expect_error({"run", "m.toml", "-z"}, "unknown option '-z' of 'shmoo run'");
  expect_error({"run"}, "MODEL is required");
  expect_error({"run", "m.toml", "-o", out(), "-n", "0"}, "-n is '0'; a whole number from 1 to 524287 is needed");
  expect_error({"run", "m.toml", "-o", out(), "-n", "ten"}, "-n is 'ten'; a whole number");
  expect_error({"run", "m.toml", "-o", out(), "--seed", "-4"}, "--seed is '-4'; a whole number");
  expect_error({"run", "m.toml", "-o", out(), "--threads", "2.5"}, "--threads is '2.5'");
  expect_error({"run", "m.toml", "-o", out(), "--set", "seed"}, "--set is 'seed'; path=value is needed");
  expect_error({"run", "m.toml", "-o", "/no/such/place/x.h5"}, "the folder /no/such/place does not exist");
  expect_error({"run", "m.toml", "extra.toml", "-o", out()}, "extra.toml");
  expect_error({"info", out("none.h5")}, "does not exist; a result file of 'shmoo run' is needed");
  std::ofstream(scratch / "text.h5") << "no HDF5";
  expect_error({"info", out("text.h5")}, "is no result file");
}

TEST_F(CommandLine, HelpVersionSchemaAndCheckEndWell) {
  EXPECT_EQ(call({"--help"}).code, 0);
  EXPECT_NE(call({"run", "--help"}).out.find("--resume"), std::string::npos);
  EXPECT_NE(call({"--version"}).out.find("shmoo "), std::string::npos);
  EXPECT_EQ(call({"schema"}).out, "{\"$schema\": \"x\"}\n");
  EXPECT_NE(call({"check", "m.toml"}).out.find("no mistakes"), std::string::npos);
  const auto bad = call({"check", "bad.toml"});
  EXPECT_EQ(bad.code, exit_input);
  EXPECT_EQ(bad.err, "bad.toml:3:7: error: unknown key 'spacng'\nbad.toml:9:1: error: no unit\n");
}

TEST_F(CommandLine, RunsAndTellsWhatIsInTheResult) {
  const auto run = call({"run", "m.toml", "-o", out(), "-n", "3", "--threads", "2", "--quiet"});
  EXPECT_EQ(run.code, exit_done) << run.err;
  EXPECT_EQ(run.err, "");
  const auto info = call({"info", out()});
  EXPECT_EQ(info.code, exit_done) << info.err;
  for (const auto* part :
       {"status        done", "3 of 3, seed 7", "total_L", "balanced in every", "walk.toml", "velocity", "m/s"}) {
    EXPECT_NE(info.out.find(part), std::string::npos) << part << " missing in\n" << info.out;
  }
}

TEST_F(CommandLine, AnExistingResultIsNotLostByAccident) {
  EXPECT_EQ(call({"run", "m.toml", "-o", out(), "-n", "2", "--quiet"}).code, exit_done);
  expect_error({"run", "m.toml", "-o", out(), "-n", "3"},
               "exists (2 of 2 realisations of \"A walk \"in\" the dark\", status done); --resume");
  EXPECT_EQ(call({"run", "m.toml", "-o", out(), "-n", "4", "--resume"}).code, exit_done);
  EXPECT_EQ(glance_at(out()).done, 4u);
  EXPECT_EQ(call({"run", "m.toml", "-o", out(), "--resume"}).code, exit_done);
  EXPECT_EQ(glance_at(out()).done, 4u);
  expect_error({"run", "m.toml", "-o", out(), "--resume", "--set", "domain.spacing=\"2 um\""},
               "made from another model");
  EXPECT_EQ(call({"run", "m.toml", "-o", out(), "-n", "1", "--force"}).code, exit_done);
  EXPECT_EQ(glance_at(out()).done, 1u);
  std::ofstream(scratch / "other.h5") << "precious";
  expect_error({"run", "m.toml", "-o", out("other.h5")}, "it is no result of shmoo");
  expect_error({"run", "m.toml", "-o", out("other.h5"), "--resume"}, "cannot resume");
}

TEST_F(CommandLine, InterruptsEndWith130AndSayHowToGoOn) {
  before = [](std::uint32_t k) {
    if (k == 2) std::raise(SIGTERM);
  };
  const auto stopped =
      call({"run", "my model.toml", "-o", out(), "-n", "5", "--threads", "1", "--set", "a.b=\"1 um\""});
  EXPECT_EQ(stopped.code, exit_interrupted);
  EXPECT_NE(stopped.err.find("keeps 2 finished realisations of 5"), std::string::npos) << stopped.err;
  EXPECT_NE(
      stopped.err.find("shmoo run 'my model.toml' -o " + out() + " -n 5 --threads 1 --set 'a.b=\"1 um\"' --resume"),
      std::string::npos)
      << stopped.err;
  before = {};
  EXPECT_EQ(
      call({"run", "my model.toml", "-o", out(), "-n", "5", "--threads", "1", "--set", "a.b=\"1 um\"", "--resume"})
          .code,
      exit_done);
  EXPECT_EQ(glance_at(out()).done, 5u);
}

TEST_F(CommandLine, FailuresEndWith2AndSayWhereTheLastGoodStateIs) {
  before = [](std::uint32_t k) {
    if (k == 3) throw base::RunError("the step fell below 1e-12 s");
  };
  const auto failed = call({"run", "m.toml", "-o", out(), "-n", "6", "--threads", "1"});
  EXPECT_EQ(failed.code, exit_failed);
  EXPECT_NE(failed.err.find("error: realisation 3: the step fell below 1e-12 s"), std::string::npos) << failed.err;
  EXPECT_NE(failed.err.find("keeps 3 finished realisations of 6"), std::string::npos) << failed.err;
  EXPECT_NE(call({"info", out()}).out.find("failed: realisation 3"), std::string::npos);
}

TEST_F(CommandLine, PartsOfAnEnsembleMakeTheWhole) {
  const auto run = [&](const std::string& part, const std::string& name) {
    return call({"run", "m.toml", "-o", out(name), "-n", "7", "--part", part, "--quiet"});
  };
  EXPECT_EQ(call({"run", "m.toml", "-o", out("whole.h5"), "-n", "7", "--quiet"}).code, exit_done);
  for (const std::string part : {"1", "2", "3"}) EXPECT_EQ(run(part + "/3", part + ".h5").code, exit_done);
  EXPECT_EQ(glance_at(out("1.h5")).status, "part");
  EXPECT_EQ(glance_at(out("1.h5")).done, 3u);
  EXPECT_EQ(call({"merge", out("3.h5"), out("1.h5"), out("2.h5"), "-o", out("all.h5")}).code, exit_done);
  EXPECT_EQ(glance_at(out("all.h5")).status, "done");
  const auto same = "h5diff --exclude-path=/provenance '" + out("all.h5") + "' '" + out("whole.h5") + "' >/dev/null";
  EXPECT_EQ(std::system(same.c_str()), 0);

  EXPECT_EQ(call({"merge", out("1.h5"), out("3.h5"), "-o", out("some.h5")}).code, exit_done);
  EXPECT_EQ(glance_at(out("some.h5")).status, "part");
  EXPECT_EQ(call({"run", "m.toml", "-o", out("some.h5"), "--resume", "--quiet"}).code, exit_done);
  EXPECT_EQ(glance_at(out("some.h5")).status, "done");
}

TEST_F(CommandLine, PartsThatDoNotFitAreRefused) {
  EXPECT_EQ(call({"run", "m.toml", "-o", out("1.h5"), "-n", "4", "--part", "1/2", "--quiet"}).code, exit_done);
  EXPECT_EQ(call({"run", "m.toml", "-o", out("s.h5"), "-n", "4", "--part", "2/2", "--seed", "9", "--quiet"}).code, 0);
  expect_error({"merge", out("1.h5"), out("1.h5"), "-o", out("a.h5")},
               "holds realisation 0, which a part named before");
  expect_error({"merge", out("1.h5"), out("s.h5"), "-o", out("a.h5")}, "it was made with seed 9");
  expect_error({"merge", out("none.h5"), "-o", out("a.h5")}, "none.h5");
  expect_error({"merge", out("1.h5"), "-o", out("1.h5")}, "exists; --force replaces it");
  EXPECT_FALSE(std::filesystem::exists(out("a.h5")));
  for (const std::string part : {"3", "0/2", "3/2", "1/", "a/b"})
    expect_error({"run", "m.toml", "-o", out("p.h5"), "--part", part}, "--part");
}

TEST_F(CommandLine, PlotAndExportSayWhatTheyCannotDo) {
  EXPECT_EQ(call({"run", "m.toml", "-o", out(), "-n", "3", "--quiet"}).code, exit_done);
  expect_error({"plot", out(), "-o", out("x.png")}, "6 pictures do not fit into");
  expect_error({"plot", out(), "-o", out("x.png"), "--field", "velocty"},
               "has no field 'velocty'; did you mean 'velocity'?; it has: D, L, velocity");
  expect_error({"plot", out(), "-o", out("x.png"), "--observable", "total"}, "has no observable 'total'");
  expect_error({"plot", out(), "-o", out("x.png"), "--field", "L", "--time", "soon"},
               "--time is 'soon'; 'all' or a time such as '0.8 s'");
  expect_error({"plot", out(), "-o", out("x.png"), "--around"}, "--around needs --field NAME");
  expect_error({"plot", out(), "-o", out() + "/x"}, "cannot make the folder");
  expect_error({"export", out(), "--to", "vtx", "-o", out("d")},
               "--to is 'vtx'; did you mean 'vtk'?; allowed: vtk, csv");
  expect_error({"export", out(), "-o", out("d")}, "--to is required");
  EXPECT_NE(call({"export", out(), "--to", "vtk", "-o", out("d")}).out.find("result.pvd"), std::string::npos);
  EXPECT_EQ(call({"plot", out(), "-o", out("one.png"), "--observable", "total_L"}).code, exit_done);
  EXPECT_TRUE(std::filesystem::exists(out("one.png")));
  const auto all = call({"plot", out(), "-o", out("pictures"), "--field", "L", "--time", "all"});
  EXPECT_NE(all.out.find("field_L_00003.png"), std::string::npos) << all.out << all.err;
}

}  // namespace
}  // namespace shmoo::run
