// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include "core/saved/checkpoint.h"
#include "tests/physics/robot/child/programs.h"

namespace surefoot {

namespace {

constexpr int kSteps = 30'000;

const ChildRobot& robotOf(const Life& life) {
  return static_cast<const ChildRobot&>(life.environment());
}

/// At least a step: a life whose program has ended tries it again.
void liveTo(Life& life, std::int64_t steps) {
  do life.step();
  while (life.steps() < steps && !life.finished());
}

/// Ends the program from outside, and lives on until that is noticed.
void killProgram(Life& life) {
  ::kill(-robotOf(life).programId(), SIGKILL);
  for (int i = 0; i < 100'000 && life.unanswered().empty(); ++i) life.step();
}

std::uint64_t undisturbed() {
  static const std::uint64_t hash = [] {
    const ProgramHouse house;
    const auto life = house.life();
    liveTo(*life, kSteps);
    return life->hash();
  }();
  return hash;
}

}  // namespace

TEST(ChildRobot, AProgramThatIsTheCliffHasTheLifeOfTheCliff) {
  const ProgramHouse house;
  const auto child = house.life(), compiled = house.life("cliff");
  liveTo(*child, kSteps), liveTo(*compiled, kSteps);
  EXPECT_EQ(child->unanswered(), "");
  EXPECT_EQ(child->steps(), kSteps);
  EXPECT_EQ(child->log().totals().falls, compiled->log().totals().falls);
  EXPECT_EQ(child->hash(), compiled->hash());
}

TEST(ChildRobot, KilledAtFiftyMomentsItGoesOnToTheSameHash) {
  const ProgramHouse house;
  const auto life = house.life();
  Random random(7);
  for (int kill = 0; kill < 50; ++kill) {
    liveTo(*life, life->steps() + 1 + static_cast<int>(100 * random.uniform()));
    ASSERT_EQ(life->unanswered(), "");
    killProgram(*life);
    EXPECT_NE(life->unanswered().find("killed by the signal 9"), std::string::npos) << life->unanswered();
    EXPECT_TRUE(life->finished());
  }
  ASSERT_LT(life->steps(), kSteps);
  liveTo(*life, kSteps);
  EXPECT_EQ(life->hash(), undisturbed());
}

TEST(ChildRobot, ALifeThatItsProgramLeftIsSavedAndGoesOnElsewhere) {
  const ProgramHouse house;
  const Configuration c = house.configuration(house.file->entry.name);
  auto life = house.life();
  life->keepInputs();
  for (const int steps : {100, 777, 1500}) {
    liveTo(*life, steps);
    killProgram(*life);
    const auto saved = std::make_shared<const TensorFile>(checkpointOf(*life, c, false));
    auto resumed = resume(house.registry, saved, {});
    ASSERT_TRUE(resumed) << resumed.error().message;
    life = std::move(resumed->life);
    EXPECT_EQ(life->unanswered(), "");
  }
  liveTo(*life, kSteps);
  EXPECT_EQ(life->hash(), undisturbed());
}

TEST(ChildRobot, NobodyStartsAProgramThatIsNotAllowed) {
  const ProgramHouse house(R"(["python3", "robot.py"])", kCliff, false);
  const auto life = house.life();
  EXPECT_NE(life->unanswered().find("python3 robot.py"), std::string::npos) << life->unanswered();
  EXPECT_NE(life->unanswered().find("Nobody has allowed it"), std::string::npos);
  EXPECT_EQ(robotOf(*life).programId(), 0);
  life->step();
  EXPECT_EQ(life->steps(), 0);
  house.registry.programs->allow(house.file->program);
  liveTo(*life, kSteps);
  EXPECT_EQ(life->hash(), undisturbed());
  // Another program in the same file is another one.
  std::ofstream(house.folder.file("robot.py"), std::ios::app) << "# changed\n";
  auto again = fullRegistry();
  const auto changed = again.files->open(house.folder.file("robot.toml"));
  ASSERT_TRUE(changed);
  EXPECT_NE((*changed)->program, house.file->program);
  EXPECT_NE((*changed)->entry.name, house.file->entry.name);
}

TEST(ChildRobot, WhatItSaysWrongIsTold) {
  const auto sentence = [](const std::string& command, const std::string& program = "") {
    const ProgramHouse house(command, program);
    const auto life = house.life();
    for (int i = 0; i < 50 && life->unanswered().empty(); ++i) life->step();
    EXPECT_TRUE(life->finished());
    return life->unanswered();
  };
  const auto python = [&](const std::string& step) {
    return sentence(R"(["python3", "robot.py"])",
                    "import os, surefoot_child\nclass R:\n  def reset(self, random, parameters): return [0, 0]\n"
                    "  def step(self, levels):\n    " +
                        step + "\nsurefoot_child.serve(R())\n");
  };
  const auto expect = [](const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  expect(sentence(R"(["no-such-program"])"), "its last words:");
  expect(sentence(R"(["sh", "-c", "exit 7"])"), "it ended with the exit code 7");
  expect(sentence(R"(["sh", "-c", "echo Hello, I am no frame; sleep 1"])"), "its answer is no frame of ours");
  expect(sentence(R"(["sh", "-c", "printf half"])"), "it ended with the exit code 0");
  expect(python("return [0, 0], 0, False"), "it says: ValueError");
  expect(python("return [0, float('nan')], 0, False, False"), "it sent row = nan; it must be a finite number");
  expect(python("return [0], 0, False, False"), "1 numbers, but the file names 2: column row");
  expect(python("raise RuntimeError('the belt has slipped')"), "it says: RuntimeError: the belt has slipped");
  expect(python("print('x' * 300000); os._exit(3)"), "it ended with the exit code 3");
  expect(python("import time; time.sleep(60)"), "it did not answer within 5 s");
}

TEST(ChildRobot, AProgramWithChanceOfItsOwnIsFoundOut) {
  const ProgramHouse house(
      R"(["python3", "robot.py"])",
      "import os, surefoot_child\nclass R:\n"
      "  def reset(self, random, parameters): return [0, 0]\n"
      "  def step(self, levels): return [os.getpid() % 7 + os.urandom(1)[0] % 5, 0], 0, False, False\n"
      "surefoot_child.serve(R())\n");
  const auto life = house.life();
  liveTo(*life, 40);
  killProgram(*life);
  life->step();
  EXPECT_NE(life->unanswered().find("does not do the same again"), std::string::npos) << life->unanswered();
}

TEST(ChildRobot, NothingOfItIsLeft) {
  int id = 0;
  {
    const ProgramHouse house(R"(["sh", "-c", "sleep 100 & exec python3 robot.py"])");
    const auto life = house.life();
    liveTo(*life, 10);
    id = robotOf(*life).programId();
    ASSERT_GT(id, 0);
  }
  EXPECT_NE(::kill(-id, 0), 0);
}

}  // namespace surefoot
