// SPDX-License-Identifier: GPL-3.0-or-later
// Journals as a user meets them: written, lived again, damaged.
#include <regex>

#include "tests/app/program.h"

namespace surefoot {

TEST(JournalFile, AJournalIsLivedAgain) {
  const Folder folder;
  const std::string journal = folder.file("life.jsonl"), q = folder.file("q");
  run("train --minutes 0.2 --save " + q);
  const std::string hash = hashOf("--minutes 1 --load " + q +
                                  " --at 500:policy.epsilon=0.2 --at 700:policy=softmax --at 900:push=0.1 --at "
                                  "2000:environment.damping=0.01 --journal " +
                                  journal);
  EXPECT_EQ(run("replay " + journal + " --verify")["lives"][0]["hash"], hash);
  const std::string text = contentOf(journal);
  std::ofstream(folder.file("other.jsonl")) << std::regex_replace(text, std::regex("\"0.2\""), "\"0.3\"");
  const Finished other = surefoot("replay " + folder.file("other.jsonl") + " --verify");
  EXPECT_EQ(other.code, 5);
  EXPECT_NE(other.err.find(hash), std::string::npos) << other.err;
  std::filesystem::remove(q);
  expectRefusal("replay " + journal, 3, {q, "No such file"});
  expectRefusal("train --minutes 1 --at 5:policy.epsilon", 2, {"STEP:KEY=VALUE"});
  expectRefusal("train --minutes 1 --at x:policy.epsilon=1", 2, {"STEP:KEY=VALUE"});
  expectRefusal("train --minutes 1 --at 5:policy.epsilon=2", 2, {"policy.epsilon", "step 5", "0 to 1"});
  expectRefusal("train --minutes 1 --at 5:features.tilings=2", 2, {"new table"});
  expectRefusal("train --episodes 1 --environment cliff --at 5:push=1", 2, {"no body"});
}

TEST(JournalFile, ALifeIsLivedAnewFromAnyFileOfIt) {
  const Folder folder;
  const std::string journal = folder.file("life.jsonl"), session = folder.file("session"), q = folder.file("q");
  const std::string hash = hashOf("--minutes 1 --seed 4 --at 500:policy.epsilon=0.2 --at 900:push=0.3 --journal " +
                                  journal + " --checkpoint " + session + " --save " + q);
  EXPECT_EQ(hashOf("--from " + journal), hash);
  EXPECT_EQ(hashOf("--from " + session), hash);
  EXPECT_EQ(hashOf("--from " + q), hashOf("--minutes 1 --seed 4 --set policy.epsilon=0.2"));
  EXPECT_NE(hashOf("--from " + journal + " --set agent.discount=0.9"), hash) << "what is set comes on top";
  EXPECT_NE(hashOf("--from " + journal + " --at 950:policy.epsilon=0"), hash);
  EXPECT_EQ(run("train --from " + journal + " --lives 2 --minutes 0.5")["lives"].size(), 2u);
  expectRefusal("train --from " + journal + " --policy trl", 2, {"--policy", "--from"});
  expectRefusal("train --from " + journal + " --resume " + session, 2, {"--from", "--resume"});
  expectRefusal("train --from " + folder.file("none"), 3, {"none"});
}

TEST(JournalFile, WhatCannotBeLivedAgainIsTheJournalsFault) {
  const Folder folder;
  const std::string journal = folder.file("j"), other = folder.file("other");
  run("train --episodes 20 --environment chain --at 10:policy.epsilon=0.2 --journal " + journal);
  const std::string text = contentOf(journal);
  for (const auto& [from, to] : {std::pair{"\"policy.epsilon\",\"step\"", "\"eolicy.epsilon\",\"step\""},
                                 std::pair{"\"value\":\"0.2\"", "\"value\":\"7\""},
                                 std::pair{"\"policy.epsilon\",\"step\"", "\"features.tilings\",\"step\""}}) {
    std::ofstream(other) << std::regex_replace(text, std::regex(from), to);
    expectRefusal("replay " + other, 3, {other});
  }
  std::ofstream(other) << std::regex_replace(text, std::regex("\"episodes\":20,\"falls\""),
                                             "\"episodes\":21,\"falls\"");
  EXPECT_EQ(surefoot("replay " + other + " --verify").code, 5);
}

// Two lives that part at a push, two that are the same, two logs; codes as those of diff.
TEST(DifferenceCommand, TellsWhereTwoLivesPart) {
  const Folder folder;
  const auto live = [&](const std::string& name, const std::string& options) {
    hashOf("--episodes 20 --journal " + folder.file(name + ".jsonl") + " --log " + folder.file(name + ".csv") +
           options);
    return folder.file(name);
  };
  const std::string a = live("a", ""), same = live("same", ""), pushed = live("pushed", " --at 500:push=0.05");
  const Finished equal = surefoot("difference " + a + ".jsonl " + same + ".jsonl");
  EXPECT_EQ(equal.code, 0) << equal.err;
  EXPECT_NE(equal.out.find("are the same"), std::string::npos) << equal.out;
  EXPECT_EQ(surefoot("difference " + a + ".csv " + same + ".csv").code, 0);
  const Finished other = surefoot("difference " + a + ".jsonl " + pushed + ".jsonl");
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.out.find("told at step 500: nothing and push = 0.05"), std::string::npos) << other.out;
  EXPECT_NE(other.out.find("after 500 equal steps"), std::string::npos) << other.out;
  const Finished json = surefoot("difference " + a + ".csv " + pushed + ".csv --json");
  EXPECT_EQ(json.code, 1);
  const auto parsed = nlohmann::json::parse(json.out);
  EXPECT_EQ(parsed["differ"], true);
  EXPECT_EQ(parsed["kind"], "log");
  EXPECT_EQ(parsed["parting"]["life"], 0);
  expectRefusal("difference " + a + ".csv " + a + ".jsonl", 3, {"only two of a kind"});
  expectRefusal("difference " + a + ".csv", 2, {"FIRST SECOND"});
  expectRefusal("difference " + a + ".csv " + folder.file("none"), 3, {"none"});
}

}  // namespace surefoot
