// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/program.h"

namespace surefoot {

TEST(Follow, OnlyWhatGrowsCanBeFollowed) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors"), text = folder.file("plan.toml");
  ASSERT_EQ(surefoot("train --episodes 3 --save " + q).code, 0);
  std::ofstream(text) << "lives = 3\n";
  expectRefusal("window --follow " + q, 3, {"q.safetensors", "Q-function", "--load"});
  expectRefusal("window --follow " + text, 3, {"plan.toml", "neither a store of results nor a checkpoint"});
  expectRefusal("window --follow " + folder.file("none/results.sqlite"), 3, {"there is no folder"});
  expectRefusal("window --follow " + folder.file(""), 3, {"not a regular file"});
  expectRefusal("window --follow", 2, {"a value is needed"});
  // All is well but for the display.
  expectRefusal("window --follow " + folder.file("results.sqlite"), 2, {"no display"});
}

TEST(Follow, NothingThatBeginsALifeStandsBesideIt) {
  for (const char* other : {"--turbo", "--load x", "--set policy.epsilon=0", "--seed 3", "--json", "--lesson a",
                            "--environment leo", "--minutes 3", "--log x.csv", "--at 3:push=1"})
    expectRefusal(std::string("window --follow results.sqlite ") + other, 2,
                  {"--follow", std::string(other).substr(0, std::string(other).find(' '))});
}

}  // namespace surefoot
