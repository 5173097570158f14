// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in plans and on the command line: whole ones are whole, large seeds are kept, and what is printed is read.
#include "tests/app/program.h"

namespace surefoot {

namespace {

/// A plan with a line at its head and some in its one condition.
std::string planWith(const Folder& folder, const std::string& head, const std::string& condition) {
  const std::string path = folder.file("plan.toml");
  std::ofstream(path) << head << "\n[base]\nenvironment = \"cliff\"\n[[condition]]\nname = \"a\"\n"
                      << condition << "\n";
  return path;
}

}  // namespace

TEST(PlanNumbers, WholeNumbersAreNotCutOff) {
  const Folder folder;
  const auto refused = [&](const std::string& head, const std::string& condition, const std::string& key) {
    expectRefusal("experiment --dry-run " + planWith(folder, head, condition), 2,
                  {key, "whole number", "plan.toml, line"});
  };
  refused("lives = 1", "episodes = 1.9", "episodes");
  refused("lives = 1", "episodes = 0.5", "episodes");
  refused("lives = 1.5", "episodes = 9", "lives");
  refused("lives = 1\nseed = 1.5", "episodes = 9", "seed");
  refused("lives = 1\nseed = -1", "episodes = 9", "seed");
  refused("lives = 1", "episodes = 9\npre-learning.until = 1\npre-learning.cap = 20.5", "cap");
  refused("lives = 1", "episodes = 9\npre-learning.until = 1\npre-learning.pool = 1.5", "pool");
  refused("lives = 1", "episodes = 9\nset.features.tilings = 4.5", "tilings");
  EXPECT_EQ(surefoot("experiment --dry-run " + planWith(folder, "lives = 2.0", "episodes = 1e3")).code, 0);
}

TEST(PlanNumbers, EverySeedIsTakenAsItIsPrinted) {
  const Folder folder;
  for (const char* seed : {"0", "9223372036854775807", "9223372036854775808", "18446744073709551615"}) {
    const std::string bare = std::string("lives = 1\nseed = ") + seed + "  # a comment";
    const auto plain = run("experiment --dry-run " + planWith(folder, bare, "episodes = 9"));
    const auto quoted = run("experiment --dry-run " +
                            planWith(folder, std::string("lives = 1\nseed = \"") + seed + "\"", "episodes = 9"));
    const auto option =
        run("experiment --seed " + std::string(seed) + " --dry-run " + planWith(folder, "lives = 1", "episodes = 9"));
    EXPECT_EQ(plain["seed"].dump(), seed);
    EXPECT_EQ(quoted, plain);
    EXPECT_EQ(option, plain);
  }
  expectRefusal("experiment --dry-run " + planWith(folder, "seed = 18446744073709551616", "episodes = 9"), 2,
                {"seed", "18446744073709551615"});
}

TEST(PlanNumbers, TheCommandLineReadsWhatTheProgramPrints) {
  const auto episodes = [](const std::string& text) {
    return run("train --environment cliff --episodes '" + text + "'")["lives"][0]["episodes"];
  };
  EXPECT_EQ(episodes("1,000"), 1000);
  expectRefusal("train --environment cliff --episodes 1,5", 2, {"--episodes", "1.5", "15"});
  expectRefusal("train --environment cliff --episodes 1.9", 2, {"--episodes", "whole number"});
  expectRefusal("train --minutes 1,5", 2, {"--minutes", "1.5", "15"});
  expectRefusal("train --minutes 1 --set policy.epsilon=0,05", 2, {"policy.epsilon", "0.05", "005"});
  const auto trl = run("train --minutes '0.1 min' --policy trl --set 'policy.threshold=−1,000'");
  EXPECT_EQ(trl["configuration"]["parameters"]["policy.threshold"], -1000);
  EXPECT_EQ(run("train --environment cliff --episodes 9 --seed 18,446,744,073,709,551,615")["seed"].dump(),
            "18446744073709551615");
  EXPECT_EQ(run("probabilities --q '1,000; −2.5; 3e−1'")["q"], (std::vector<double>{1000, -2.5, 0.3}));
  EXPECT_EQ(run("probabilities --q '1 2 3'")["q"], (std::vector<double>{1, 2, 3}));
  expectRefusal("probabilities --q 100,200", 2, {"--q", "100200", "100; 200", "; or blanks"});
  expectRefusal("probabilities --q '1;1,5'", 2, {"--q, value 2", "1.5", "15"});
}

}  // namespace surefoot
