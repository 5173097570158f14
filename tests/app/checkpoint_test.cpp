// SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints as a user meets them: killed, resumed, in the way of other files.
#include <chrono>
#include <sstream>

#include "core/basics/random.h"
#include "tests/app/program.h"

namespace surefoot {

// 50 kills, spread over the run by a seed: whatever there is can be read, and goes on to the same end.
TEST(CheckpointFile, KilledAtAnyMomentACheckpointIsWholeAndGoesOn) {
  const Folder folder;
  const std::string file = folder.file("life"), arguments = "--minutes 4 --agent sarsa-2q";
  const std::string expected = hashOf(arguments);
  const std::string fresh = std::string(SUREFOOT_PROGRAM) + " train " + arguments;
  // How long this machine takes for a start and five checkpoints: the kills are spread around it.
  const auto start = std::chrono::steady_clock::now();
  run("train --minutes 0.05 --agent sarsa-2q --every 0.01 --checkpoint " + folder.file("short"));
  const double five = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Random random(11);
  int found = 0;
  for (int kill = 0; kill < 50; ++kill) {
    const bool resuming = std::filesystem::exists(file);
    const std::string command = resuming ? std::string(SUREFOOT_PROGRAM) + " train --resume " + file : fresh;
    std::ostringstream seconds;
    seconds << random.uniform(0.2, 2.0) * five;
    static_cast<void>(std::system(
        ("timeout -s KILL " + seconds.str() + " " + command + " --checkpoint " + file + " --every 0.01 >/dev/null 2>&1")
            .c_str()));
    if (!std::filesystem::exists(file)) continue;
    ++found;
    ASSERT_EQ(surefoot("inspect " + file).code, 0) << "after kill " << kill;
    if (kill % 7 != 0) continue;
    ASSERT_EQ(hashOf("--resume " + file), expected) << "after kill " << kill;
  }
  EXPECT_GT(found, 25);
  EXPECT_EQ(hashOf("--resume " + file), expected);
}

TEST(CheckpointFile, ACheckpointOfAnotherLifeIsNotOverwritten) {
  const Folder folder;
  const std::string file = folder.file("life");
  run("train --minutes 0.2 --checkpoint " + file);
  const std::string before = contentOf(file);
  expectRefusal("train --minutes 0.2 --checkpoint " + file, 3, {"exists", "--resume"});
  EXPECT_EQ(contentOf(file), before);
  expectRefusal("train --resume " + file + " --set policy.epsilon=0.1", 2, {"--set", "--resume"});
  expectRefusal("train --resume " + file + " --seed 3", 2, {"--seed"});
  expectRefusal("train --resume " + file + " --log " + folder.file("log.csv"), 2, {"--log"});
  expectRefusal("train --minutes 1 --every 3", 2, {"--checkpoint"});
  expectRefusal("train --minutes 1 --lives 2 --save x", 2, {"--save", "one life"});
  EXPECT_EQ(run("train --minutes 0.4 --resume " + file)["lives"][0]["steps"], 4800) << "it may be longer";
}

// The disk is full when a checkpoint is written: the old one stays, the run goes on, and the program says so.
TEST(CheckpointFile, AFullDiskLeavesTheOldCheckpoint) {
  const Folder folder;
  const std::string file = folder.file("life");
  run("train --environment chain --episodes 5 --checkpoint " + file);
  const std::string before = contentOf(file);
  const std::string command = "(ulimit -f 1; exec " + std::string(SUREFOOT_PROGRAM) + " train --episodes 50 --resume " +
                              file + " --checkpoint " + file + " >/dev/null 2>" + folder.file("err") + ")";
  const int status = std::system(("bash -c '" + command + "'").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_EQ(contentOf(file), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("")), {}), 2) << "the checkpoint and err";
}

TEST(CheckpointFile, ACheckpointBehindALinkStaysBehindIt) {
  const Folder folder;
  const std::string file = folder.file("life"), link = folder.file("link");
  run("train --episodes 5 --environment chain --checkpoint " + file);
  std::filesystem::create_symlink(file, link);
  run("train --episodes 9 --resume " + link + " --checkpoint " + link);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_NE(surefoot("inspect " + file).out.find("9 episodes"), std::string::npos);
}

}  // namespace surefoot
