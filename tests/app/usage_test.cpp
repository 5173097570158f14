// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

namespace surefoot {

TEST(Usage, HelpAndVersionEverywhere) {
  for (const char* command : {"", "train", "window", "list", "probabilities", "query", "slice", "inspect", "resample",
                              "replay", "bench", "rollout", "robustness", "export"}) {
    for (const char* option : {"--help", "-h", "--version"}) {
      const Finished run = surefoot(std::string(command) + " " + option);
      EXPECT_EQ(run.code, 0) << command << " " << option;
      EXPECT_NE(run.out.find("urefoot"), std::string::npos) << command << " " << option << run.out;
      EXPECT_EQ(run.err, "");
    }
  }
}

TEST(Usage, UnknownWordsNameTheNearestKnownOne) {
  expectRefusal("trian", 2, {"train"});
  expectRefusal("train --epsiodes 3", 2, {"--epsiodes", "--episodes"});
  expectRefusal("train --episodes 3 extra", 2, {"extra"});
  expectRefusal("train --episodes 3 --policy softmacks", 2, {"softmacks", "softmax"});
  expectRefusal("train --episodes 3 --environment pendulun", 2, {"pendulum"});
  expectRefusal("train --episodes 3 --scenario 7", 2, {"7", "actual"});
  expectRefusal("train --episodes 3 --preset leb", 2, {"lab"});
  expectRefusal("train --episodes 3 --agent q", 2, {"sarsa"});
  expectRefusal("train --episodes 3 --features tiles", 2, {"tile-coder"});
  expectRefusal("train --episodes 3 --set policy.epsilom=1", 2, {"policy.epsilon"});
}

TEST(Usage, NumbersOutOfRangeNameValueAndRange) {
  expectRefusal("train --episodes 3 --set policy.epsilon=1.5", 2, {"policy.epsilon", "1.5", "0 to 1"});
  expectRefusal("train --episodes 3 --set policy.epsilon=nan", 2, {"policy.epsilon", "nan"});
  expectRefusal("train --episodes 3 --set policy.epsilon=inf", 2, {"inf"});
  expectRefusal("train --episodes 3 --set policy.epsilon=1e999", 2, {"1e999"});
  expectRefusal("train --episodes 3 --set policy.epsilon=", 2, {"policy.epsilon"});
  expectRefusal("train --episodes 3 --set features.tilings=2.5", 2, {"features.tilings", "whole number"});
  expectRefusal("train --episodes 3 --set agent.trace=fading", 2, {"agent.trace", "replacing or accumulating"});
  expectRefusal("train --episodes 3 --set policy.epsilon", 2, {"KEY=VALUE"});
  expectRefusal("train --episodes 3 --set =3", 2, {"KEY=VALUE"});
  expectRefusal("train --episodes 0", 2, {"--episodes", "1 to"});
  expectRefusal("train --episodes 1e3", 2, {"--episodes", "1e3"});
  expectRefusal("train --minutes -1", 2, {"--minutes", "-1"});
  expectRefusal("train --minutes 0", 2, {"--minutes"});
  expectRefusal("train --minutes nan", 2, {"--minutes", "nan"});
  expectRefusal("train --episodes 3 --lives 0", 2, {"--lives", "1 to"});
  expectRefusal("train --episodes 3 --lives -2", 2, {"--lives", "-2"});
  expectRefusal("train --episodes 3 --jobs 0", 2, {"--jobs", "1 to"});
  expectRefusal("train --episodes 3 --seed -1", 2, {"--seed", "-1"});
  expectRefusal("train --episodes 3 --seed 18446744073709551616", 2, {"--seed"});
}

TEST(Usage, ImpossibleCombinationsAreRefused) {
  expectRefusal("train", 2, {"--minutes", "--episodes"});
  expectRefusal("train --episodes 3 --policy softmax --set policy.threshold=1", 2, {"policy.threshold", "trl"});
  expectRefusal("train --episodes 3 --set environment.start_angle=1.5", 2, {"start_angle", "fall_angle"});
  expectRefusal(
      "train --episodes 3 --set environment.fall_angle=0.06 --set environment.start_angle=0.01 --set "
      "environment.balanced_angle=0.1",
      2, {"balanced_angle"});
  expectRefusal("train --episodes 3 --set features.initial_low=3", 2, {"features.initial_low"});
  expectRefusal("train --episodes 3 --set features.pole_angle=1000 --set features.pole_rate=1000", 2, {"tiles"});
  expectRefusal("train --episodes 3 --set policy.epsilon=0.1 --set policy.epsilon=0.2", 2, {"twice"});
  expectRefusal("train --episodes 3 --episodes 4", 2, {"--episodes"});
  expectRefusal("train --episodes", 2, {"--episodes", "value"});
  expectRefusal("train --episodes 3 --log --json", 2, {"--log", "--json"});
  expectRefusal("train --seed --episodes 3", 2, {"--seed"});
  expectRefusal("--policy trl", 2, {"--policy", "window"});
  expectRefusal("train --episodes 3 --set policy.epsilon=0.1 junk", 2, {"junk"});
  expectRefusal("train --episodes 3 --set '[policy.epsilon=.1]'", 2, {"[policy.epsilon"});
  expectRefusal("train --episodes '1\n2' --policy '\033[31m'", 2);
  expectRefusal("''", 2, {"argument 1"});
  // Of a script, for instance, whose variable is not set: nothing is written to "/" for that.
  for (const char* command :
       {"train --episodes 3 --save ''", "train --episodes 3 --load ''", "train --resume ''",
        "experiment plan.toml --out ''", "experiment plan.toml --out=", "export s.sqlite --csv ''",
        "merge a b --out ''", "reproduce 2.1 --out ''", "train --set ''", "window --from ''"})
    expectRefusal(command, 2, {"--", "empty"});
  for (const char* command : {"experiment ''", "statistics ''", "inspect ''", "replay ''", "merge a '' --out c"})
    expectRefusal(command, 2, {"argument", "empty"});
  expectRefusal("window --lives 2", 2, {"--lives"});
}

TEST(Usage, WithoutADisplayTheWindowSaysSo) {
  expectRefusal("window", 2, {"surefoot train"});
}

// Whoever reads may stop reading: no message, and what is to be written to files is written.
TEST(Usage, APipeThatIsClosedEndsEveryCommandQuietly) {
  const Folder folder;
  const std::string q = folder.file("q"), j = folder.file("j"), store = folder.file("s.sqlite");
  run("train --environment cliff --episodes 9 --save " + q + " --journal " + j);
  std::ofstream(folder.file("plan.toml"))
      << "lives = 1\n[base]\nepisodes = 9\nenvironment = \"cliff\"\n[[condition]]\nname = \"a\"\n";
  for (const std::string& command :
       {std::string("list"), std::string("list --json"), std::string("--help"), std::string("train --help"),
        std::string("probabilities --q 1,2"), "query --state 0,0 " + q, "inspect " + q, "replay " + j,
        "experiment --dry-run " + folder.file("plan.toml"),
        "experiment --json " + folder.file("plan.toml") + " --out " + store, "statistics " + store,
        "train --environment cliff --episodes 9 --save " + folder.file("more")}) {
    const std::string out = folder.file("said");
    const std::string shell = "{ sleep 0.1; " SUREFOOT_PROGRAM " " + command + "; echo $? >" + folder.file("code") +
                              "; } 2>" + out + " | true";
    const std::string until = "; while [ ! -e " + folder.file("code") + " ]; do sleep 0.05; done";
    ASSERT_EQ(std::system((shell + until).c_str()), 0);
    EXPECT_EQ(contentOf(folder.file("code")), "0\n") << command;
    EXPECT_EQ(contentOf(out), "") << command;
    std::filesystem::remove(folder.file("code"));
  }
  EXPECT_TRUE(std::filesystem::exists(folder.file("more")));
  EXPECT_EQ(surefoot("statistics " + store).code, 0);
}

}  // namespace surefoot
