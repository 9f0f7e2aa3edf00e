// A room includes only rooms to its left: base <- scene <- sph <- {hydro | rdme} <- coupling <- run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> allowed{
    {"base", {"base"}},
    {"scene", {"base", "scene"}},
    {"sph", {"base", "scene", "sph"}},
    {"hydro", {"base", "scene", "sph", "hydro"}},
    {"rdme", {"base", "scene", "sph", "rdme"}},
    {"coupling", {"base", "scene", "sph", "hydro", "rdme", "coupling"}},
    {"run", {"base", "scene", "sph", "hydro", "rdme", "coupling", "run"}},
};

std::string backward_arrow(const std::string& room, const std::string& line) {
  static const std::regex pattern{R"(^\s*#\s*include\s*"(\w+)/)"};
  std::smatch match;
  if (!std::regex_search(line, match, pattern)) return {};
  const std::string target = match[1];
  return allowed.contains(target) && !allowed.at(room).contains(target) ? target : std::string{};
}

TEST(Arrows, TheTestSeesABackwardArrow) {
  EXPECT_EQ(backward_arrow("base", "#include \"run/command_line.hpp\""), "run");
  EXPECT_EQ(backward_arrow("hydro", "  # include \"rdme/state.hpp\""), "rdme");
  EXPECT_EQ(backward_arrow("run", "#include \"base/error.hpp\""), "");
}

TEST(Arrows, NoRoomIncludesARoomToItsRight) {
  const fs::path source = fs::path(SHMOO_SOURCE_DIR) / "src";
  std::size_t files = 0;
  for (const auto& [room, rooms] : allowed) {
    ASSERT_TRUE(fs::is_directory(source / room)) << room;
    for (const auto& entry : fs::recursive_directory_iterator(source / room)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++files;
      std::ifstream text(entry.path());
      std::string line;
      for (int number = 1; std::getline(text, line); ++number) {
        EXPECT_EQ(backward_arrow(room, line), "") << entry.path() << ":" << number << ": " << line;
      }
    }
  }
  EXPECT_GT(files, 20u);
}

}  // namespace
