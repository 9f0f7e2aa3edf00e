// Damaged files: a file either loads or is refused with base::InputError; nothing else may happen.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "scene/document.hpp"
#include "scene/read.hpp"

namespace shmoo::scene {
namespace {

const std::string data = SHMOO_SOURCE_DIR "/tests/data/";
const std::string sketch = read_bytes(data + "yeast-sketch.toml");
const std::vector<std::string> originals{sketch, read_bytes(data + "good-models/reactions-2d.toml"),
                                         read_bytes(data + "good-models/flow-3d.toml")};

// True where the text is a model.
bool loads(const std::string& text) {
  try {
    read_scene_text(text, "hostile.toml");
    return true;
  } catch (const base::InputError& error) {
    EXPECT_FALSE(error.diagnostics().empty());
    return false;
  }
}

std::size_t below(base::RandomSequence& random, std::size_t limit) {
  return static_cast<std::size_t>(random.uniform() * static_cast<double>(limit));
}

TEST(Hostile, EveryTruncation) {
  for (std::size_t length = 0; length < sketch.size(); ++length) loads(sketch.substr(0, length));
  EXPECT_TRUE(loads(sketch));
}

TEST(Hostile, DamagedBytes) {
  for (std::uint64_t round = 0; round < 8000; ++round) {
    base::RandomSequence random({}, base::Stream::test, round);
    std::string text = originals[round % originals.size()];
    const std::size_t damages = 1 + below(random, 4);
    for (std::size_t i = 0; i < damages; ++i) text[below(random, text.size())] = static_cast<char>(below(random, 256));
    loads(text);
  }
}

TEST(Hostile, ShuffledLines) {
  std::vector<std::string> lines(1);
  for (const char character : sketch) {
    lines.back() += character;
    if (character == '\n') lines.emplace_back();
  }
  for (std::uint64_t round = 0; round < 4000; ++round) {
    base::RandomSequence random({}, base::Stream::test, round, 1);
    auto changed = lines;
    const std::size_t changes = 1 + below(random, 3);
    for (std::size_t i = 0; i < changes; ++i) {
      const auto from = below(random, changed.size()), to = below(random, changed.size());
      if (random.uniform() < 0.5)
        std::swap(changed[from], changed[to]);
      else
        changed[to] = changed[from];
    }
    std::string text;
    for (const auto& line : changed) text += line;
    loads(text);
  }
}

// Values of every kind in every place where a value stands.
TEST(Hostile, ForeignValues) {
  const std::vector<std::string> values{"\"\"",
                                        "0",
                                        "-1",
                                        "1e308",
                                        "nan",
                                        "inf",
                                        "true",
                                        "[]",
                                        "{}",
                                        "[[], {}]",
                                        "\"1 m\"",
                                        "\"-1e300 m\"",
                                        "1979-05-27T07:32:00Z",
                                        "[\"1 um\"]",
                                        "[1, \"a\", true]",
                                        "\"\\u0000\"",
                                        "9223372036854775807",
                                        "-9223372036854775808",
                                        "{ expression = \"x\" }",
                                        "{ a = { b = 1 } }",
                                        "[{ shape = \"union\" }]"};
  for (const std::string& original : originals) {
    for (std::size_t at = original.find(" = "); at != std::string::npos; at = original.find(" = ", at + 1)) {
      const std::size_t end = original.find('\n', at);
      // Every third value, beginning elsewhere at each place: all of them meet keys of every kind.
      for (std::size_t i = at % 3; i < values.size(); i += 3)
        loads(original.substr(0, at + 3) + values[i] + original.substr(end));
    }
  }
}

TEST(Hostile, DeepNesting) {
  std::string shape = "{ shape = \"disk\", center = [\"1 um\", \"1 um\"], radius = \"1 um\" }";
  for (int depth = 0; depth < 120; ++depth) shape = "{ shape = \"union\", of = [" + shape + "] }";
  EXPECT_FALSE(loads(sketch + "\n[[region]]\nmaterial = \"cell\"\nshape = \"union\"\nof = [" + shape + "]\n"));
  std::string key = "a";
  for (int depth = 0; depth < 100000; ++depth) key += ".a";
  EXPECT_FALSE(loads(key + " = 1"));
  EXPECT_FALSE(loads("[" + key + "]"));
  EXPECT_FALSE(loads("x = " + std::string(100000, '[')));
  EXPECT_FALSE(loads("x = " + std::string(100000, '{')));
}

}  // namespace
}  // namespace shmoo::scene
