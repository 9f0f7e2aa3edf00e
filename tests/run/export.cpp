// What is exported is read back and compared with what the result holds.
#include "run/export/export.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <regex>
#include <sstream>

#include "fake_experiment.hpp"
#include "run/ensemble.hpp"
#include "scratch.hpp"

namespace shmoo::run {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The named array of a .vtp file with appended raw data.
template <class T>
std::vector<T> vtk_array(const std::string& file, const std::string& name) {
  std::smatch match;
  const std::string head = file.substr(0, file.find("<AppendedData"));
  if (!std::regex_search(head, match, std::regex("Name=\"" + name + "\"[^>]*offset=\"([0-9]+)\""))) return {};
  const auto* raw = file.data() + file.find("encoding=\"raw\">\n_") + 17 + std::stoull(match[1]);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, raw, sizeof bytes);
  std::vector<T> values(bytes / sizeof(T));
  std::memcpy(values.data(), raw + sizeof bytes, bytes);
  return values;
}

class Export : public ::testing::Test {
 protected:
  Export() { run_ensemble(fake, {.output = scratch / "r.h5", .realisations = 3}); }
  Scratch scratch;
  FakeExperiment fake;
};

TEST_F(Export, VtkHoldsEveryRecordAndField) {
  const ResultFile result(scratch / "r.h5");
  const auto collection = contents(export_vtk(result, scratch / "vtk").front());
  for (std::size_t t = 0; t < result.times.size(); ++t) {
    const auto name = fmt::format("particles_{:05}.vtp", t);
    EXPECT_NE(collection.find(fmt::format("timestep=\"{:.17g}\" part=\"0\" file=\"{}\"", result.times[t], name)),
              std::string::npos);
    const auto file = contents(scratch / "vtk" / name);
    EXPECT_EQ(vtk_array<double>(file, "L"), result.field_slice(result.field("L"), t).mean);
    EXPECT_EQ(vtk_array<double>(file, "D_deviation"), result.field_slice(result.field("D"), t).deviation);
    EXPECT_EQ(vtk_array<double>(file, "position"), result.positions(t));
    EXPECT_EQ(vtk_array<double>(file, "TimeValue"), std::vector<double>{result.times[t]});
    EXPECT_EQ(vtk_array<std::int32_t>(file, "material"), result.material);
    const auto velocity = vtk_array<double>(file, "velocity"),
               stored = result.field_slice(result.field("velocity"), t).mean;
    ASSERT_EQ(velocity.size(), 3 * fake.particles());
    EXPECT_EQ(velocity[3 * 9], stored[2 * 9]);
    EXPECT_EQ(velocity[3 * 9 + 2], 0.0);
  }
}

TEST_F(Export, CsvHoldsEveryNumberWithAllItsDigits) {
  const ResultFile result(scratch / "r.h5");
  EXPECT_EQ(export_csv(result, scratch / "csv").size(), 6u);
  std::istringstream table(contents(scratch / "csv/field_L.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(
      line,
      "time [s],particle,material,x [m],y [m],mean [molecules],deviation [molecules],standard_error [molecules],q0.05 "
      "[molecules],q0.5 [molecules],q0.95 [molecules]");
  const auto slice = result.field_slice(result.field("L"), 0);
  for (std::size_t i = 0; i < fake.particles(); ++i) {
    ASSERT_TRUE(std::getline(table, line));
    std::vector<std::string> words;
    for (std::istringstream row(line); std::getline(row, line, ',');) words.push_back(line);
    ASSERT_EQ(words.size(), 11u);
    EXPECT_EQ(words[2], i % 8 == 0 ? "wall" : "medium");
    EXPECT_EQ(std::stod(words[5]), slice.mean[i]);
    EXPECT_EQ(std::stod(words[6]), slice.deviation[i]);
  }
  std::istringstream profile(contents(scratch / "csv/observable_row_of_L.csv"));
  std::getline(profile, line);
  EXPECT_TRUE(line.starts_with("time [s],bin,axis [m],mean [molecules/m^3],")) << line;
  EXPECT_TRUE(line.ends_with("realisation_2 [molecules/m^3]")) << line;
  std::size_t rows = 0;
  while (std::getline(profile, line)) ++rows;
  EXPECT_EQ(rows, 4u * 8u);
}

TEST_F(Export, AFolderThatCannotBeMadeIsRefused) {
  const ResultFile result(scratch / "r.h5");
  EXPECT_THROW(export_vtk(result, scratch / "r.h5"), base::InputError);
  EXPECT_THROW(export_csv(result, "/proc/x"), base::InputError);
}

}  // namespace
}  // namespace shmoo::run
