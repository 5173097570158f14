// SPDX-License-Identifier: GPL-3.0-or-later
// The library lives the same lives as the program, and shows nothing but its own calls.
#include <algorithm>
#include <sstream>

#include "tests/app/program.h"

namespace surefoot {
namespace {

struct SameLife {
  std::string configuration, arguments, minutes, episodes;
};

class Library : public testing::TestWithParam<SameLife> {};

TEST_P(Library, LivesTheSameLifeAsTheProgram) {
  const SameLife& same = GetParam();
  const std::string minutes = same.minutes.empty() ? "" : " --minutes " + same.minutes,
                    episodes = same.episodes.empty() ? "" : " --episodes " + same.episodes;
  const Finished library = finish(std::string(SUREFOOT_HASH_OF_LIFE) + " '" + same.configuration + "' " +
                                  (same.minutes.empty() ? "0" : same.minutes) + " " + same.episodes);
  ASSERT_EQ(library.code, 0) << library.err;
  EXPECT_EQ(library.out, hashOf(minutes + episodes + " " + same.arguments) + "\n");
}

const std::string kRobot = std::string(SUREFOOT_SOURCE) + "/resources/robots/hopper.toml";

INSTANTIATE_TEST_SUITE_P(
    Configurations, Library,
    testing::Values(SameLife{"{}", "", "9", ""},
                    SameLife{R"({"agent": "sarsa-2q", "policy": "trl", "seed": 4, "scenario": "3",
                                "parameters": {"policy.threshold": 30}})",
                             "--agent sarsa-2q --policy trl --seed 4 --scenario 3 --set policy.threshold=30", "9", ""},
                    SameLife{R"({"policy": "softmax", "preset": "lab", "parameters": {"policy.temperature": 0.5}})",
                             "--policy softmax --preset lab --set policy.temperature=0.5", "9", ""},
                    SameLife{R"({"environment": "compass", "seed": 12345678901234567890})",
                             "--environment compass --seed 12345678901234567890", "4", ""},
                    SameLife{R"({"environment": "leo", "seed": 2})", "--environment leo --seed 2", "2", ""},
                    SameLife{R"({"environment": "cliff", "features": "table"})", "--environment cliff --features table",
                             "", "300"},
                    SameLife{R"({"environment": ")" + kRobot + R"("})", "--environment " + kRobot, "2", ""}));

TEST(LibraryFile, ShowsItsOwnCallsOnly) {
  const Finished symbols = finish("nm -D --defined-only " + std::string(SUREFOOT_LIBRARY));
  ASSERT_EQ(symbols.code, 0) << symbols.err;
  std::istringstream lines(symbols.out);
  int calls = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = line.substr(line.rfind(' ') + 1);
    if (name.starts_with("SUREFOOT_")) continue;  // the version
    EXPECT_TRUE(name.starts_with("surefoot_")) << line;
    ++calls;
  }
  EXPECT_GT(calls, 40);
}

TEST(LibraryFile, EveryCallOfTheHeaderIsThere) {
  const Finished symbols = finish("nm -D --defined-only " + std::string(SUREFOOT_LIBRARY));
  const Finished header =
      finish("grep -oE '\\bsurefoot_[a-z_]+\\(' " + std::string(SUREFOOT_SOURCE) + "/app/library/surefoot.h | sort -u");
  std::istringstream names(header.out);
  for (std::string name; std::getline(names, name);) {
    name.pop_back();
    EXPECT_NE(symbols.out.find(" " + name + "@"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace surefoot
