// SPDX-License-Identifier: GPL-3.0-or-later
// A policy as C, compiled and asked: the same action as ours in every state.
#include "core/c_policy/c_policy.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/c_policy/c_text.h"
#include "core/files/whole_file.h"
#include "core/saved/q_file.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

constexpr int kStates = 100'000;

/// Reads states from its standard input as they lie in memory, writes an action for each.
constexpr const char* kHarness = R"(#include <stdio.h>
int policy_action(const double state[]);
int main(void) {
  double s[STATES];
  while (fread(s, sizeof s, 1, stdin) == 1) {
    const int a = policy_action(s);
    fwrite(&a, sizeof a, 1, stdout);
  }
  return 0;
}
)";

/// What was learned in a few episodes.
struct Learned {
  Configuration configuration;
  std::unique_ptr<Life> life;
  TensorFile file;
  const Task& task() const { return life->environment().task(); }
};

Learned learned(const Names& names, const std::vector<Assignment>& assignments, int episodes) {
  static const Registry registry = fullRegistry();
  auto c = configure(registry, names, assignments);
  EXPECT_TRUE(c) << (c ? "" : c.error().message);
  c->episodes = episodes;
  auto life = makeLife(registry, *c, 0, false);
  EXPECT_TRUE(life) << (life ? "" : life.error().message);
  while (!(*life)->finished()) (*life)->step();
  TensorFile file = qFileOf(**life, *c);
  return {*c, std::move(*life), std::move(file)};
}

/// States all over the ranges and beyond them, and some that are no numbers.
std::vector<double> anyStates(const Task& task, int count) {
  Random random(3);
  std::vector<double> states;
  for (int i = 0; i < count; ++i)
    for (const StateVariable& v : task.state) {
      const double reach = 0.2 * (v.high - v.low);
      double at = random.uniform(v.low - reach, v.high + reach);
      if (v.whole) at = std::round(at);
      if (i % 1000 == 7) at = std::numeric_limits<double>::quiet_NaN();
      if (i % 1000 == 8) at = random.uniform() < 0.5 ? -kInfinity : kInfinity;
      states.push_back(at);
    }
  return states;
}

std::vector<int> ourActions(const Learned& l, const std::vector<double>& states) {
  const std::size_t n = l.task().state.size();
  std::vector<double> q(l.task().actions.size());
  std::vector<int> actions;
  for (std::size_t i = 0; i < states.size(); i += n) {
    l.life->agent().values().evaluate(std::span(states).subspan(i, n), Layer::Sum, q);
    actions.push_back(static_cast<int>(std::max_element(q.begin(), q.end()) - q.begin()));
  }
  return actions;
}

bool run(const std::string& command) {
  return std::system(command.c_str()) == 0;  // NOLINT: the words are the test's own
}

/// The actions of the compiled program.
std::vector<int> theirActions(const std::string& compiler, const std::string& text, std::size_t variables,
                              const std::vector<double>& states) {
  const Folder folder;
  const auto in = [&](const char* file) { return folder.file(file); };
  std::ofstream(in("policy.c")) << text;
  std::ofstream(in("harness.c")) << kHarness;
  std::ofstream(in("states"), std::ios::binary)
      .write(reinterpret_cast<const char*>(states.data()),
             static_cast<std::streamsize>(states.size() * sizeof(double)));
  EXPECT_TRUE(run(compiler + " -std=c99 -Wall -Wextra -Wpedantic -Werror -O0 -DSTATES=" + std::to_string(variables) +
                  " -o '" + in("policy") + "' '" + in("policy.c") + "' '" + in("harness.c") + "'"));
  EXPECT_TRUE(run("'" + in("policy") + "' < '" + in("states") + "' > '" + in("actions") + "'"));
  std::ifstream file(in("actions"), std::ios::binary);
  std::vector<int> actions(states.size() / variables, -1);
  file.read(reinterpret_cast<char*>(actions.data()), static_cast<std::streamsize>(actions.size() * sizeof(int)));
  return actions;
}

constexpr const char* kSanitized = "-fsanitize=address,undefined -fno-sanitize-recover=all";

/// `others`: also with clang, where there is one.
void expectTheSame(const Learned& l, int count = kStates, bool others = false) {
  const auto text = policyAsC(l.file, l.task(), {});
  ASSERT_TRUE(text) << text.error().message;
  const std::size_t n = l.task().state.size();
  const std::vector<double> states = anyStates(l.task(), count);
  const std::vector<int> ours = ourActions(l, states);
  EXPECT_EQ(theirActions(std::string("gcc ") + kSanitized, *text, n, states), ours);
  if (!others || !run("command -v clang >/dev/null")) return;
  EXPECT_EQ(theirActions("clang", *text, n, states), ours) << "clang";
}

}  // namespace

TEST(PolicyAsC, IsTheSameForADenseTable) {
  expectTheSame(learned({}, {}, 200));
}

TEST(PolicyAsC, IsTheSameForAHashedTable) {
  expectTheSame(learned({}, {{"features.memory", "8192"}}, 100), kStates, true);
}

TEST(PolicyAsC, IsTheSameWhereAHashedTableIsFullAndBeganAtRandom) {
  expectTheSame(learned({}, {{"features.memory", "1000"}, {"features.initial_high", "1"}}, 30));
}

TEST(PolicyAsC, IsTheSameForTwoEstimates) {
  expectTheSame(learned({.agent = "sarsa-2q"}, {}, 200));
}

TEST(PolicyAsC, IsTheSameForRadialBasisFunctions) {
  expectTheSame(learned({.features = "radial-basis"}, {}, 100));
}

TEST(PolicyAsC, IsTheSameForActionsThatShareWeights) {
  expectTheSame(learned({.environment = "leo"}, {{"features.memory", "2048"}}, 10), 10'000);
}

TEST(PolicyAsC, IsTheSameForATableAndForAnAngleThatGoesRound) {
  expectTheSame(learned({.environment = "cliff", .features = "table"}, {}, 50));
  expectTheSame(
      learned({.environment = SUREFOOT_SOURCE "/resources/robots/acrobot.toml"}, {{"features.memory", "4096"}}, 5));
}

TEST(PolicyAsC, ChecksItself) {
  const Learned l = learned({}, {{"features.memory", "4096"}}, 30);
  const std::vector<double> upright = {0.1, 0.2, 0.3};
  const int right = ourActions(l, upright)[0];
  for (const int wrong : {0, 1}) {
    const auto text =
        policyAsC(l.file, l.task(), {.floats = true, .known = {{upright, (right + wrong) % 5}}, .origin = {}});
    ASSERT_TRUE(text);
    const Folder folder;
    const std::string file = folder.file("self.c");
    ASSERT_TRUE(writeWhole("c", file, *text));
    ASSERT_TRUE(
        run("gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -DPOLICY_SELF_TEST -o '" + file + ".out' '" + file + "'"));
    EXPECT_EQ(run("'" + file + ".out' >/dev/null"), wrong == 0);
  }
}

TEST(PolicyAsC, NeedsNothingAndIsSmall) {
  const Learned l = learned({}, {}, 100);
  const auto text = policyAsC(l.file, l.task(), {});
  ASSERT_TRUE(text);
  const Folder folder;
  const std::string file = folder.file("alone.c"), object = file + ".o";
  ASSERT_TRUE(writeWhole("c", file, *text));
  ASSERT_TRUE(run("gcc -std=c99 -O2 -ffreestanding -nostdlib -c -o '" + object + "' '" + file + "'"));
  EXPECT_FALSE(run("nm -u '" + object + "' | grep .")) << "it calls something that it does not have";
  EXPECT_LT(std::filesystem::file_size(object), 3'000'000u);
}

TEST(PolicyAsC, TellsTheSizeOfTablesThatAreTooLarge) {
  const Learned l = learned({.environment = "leo"}, {{"features.memory", "65536"}}, 60);
  ASSERT_GT(tableBytesOf(l.file, false), 1e6);
  TensorFile large = l.file;
  for (Tensor& t : large.tensors)
    if (t.name == "q.weights") t.shape = {1'000'000, 116};
  const auto refused = policyAsC(large, l.task(), {});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("as C its tables have 928 MB; at most 64 MB"), std::string::npos)
      << refused.error().message;
}

TEST(PolicyAsC, WordsOfAFileDoNotEndAComment) {
  EXPECT_EQ(commentInC("a */ b /* c \\\n d"), "a * / b / * c    d");
  EXPECT_EQ(inC(1.0), "1.0");
  EXPECT_EQ(inC(1e300), "1e+300");
  EXPECT_EQ(inC(0.1f), "0.1f");
  EXPECT_EQ(inC(-0.0), "-0.0");
}

}  // namespace surefoot
