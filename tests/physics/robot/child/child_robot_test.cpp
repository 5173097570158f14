// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/saved/checkpoint.h"
#include "physics/robot/child/program_files.h"
#include "tests/physics/robot/child/programs.h"
#include "tests/physics/robot/robot_files.h"

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

/// Whether a process of a group still runs. One that was killed may wait for its parent to ask for its end (state Z),
/// for ever where the first process of a container does not ask.
bool isAnyAlive(int group) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "stat");
    std::string line;
    if (!std::getline(file, line)) continue;
    std::istringstream rest(line.substr(line.rfind(')') + 1));  // behind its name, which may be anything
    char state = 'Z';
    int parent = 0, itsGroup = 0;
    if (rest >> state >> parent >> itsGroup && itsGroup == group && state != 'Z' && state != 'X') return true;
  }
  return false;
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
  EXPECT_EQ(life->unanswered(), "");  // a life that is made starts nothing yet
  life->begin();
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
  expect(python("os.write(1, b'?'); os.write(3, b'?' * 64); return [0, 0], 0, False, False"), "no frame of ours");
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

TEST(ChildRobot, AProgramThatChangesWhileItsLifeGoesOnIsFoundOut) {
  const ProgramHouse house;
  const auto life = house.life();
  liveTo(*life, 40);
  std::ofstream(house.folder.file("robot.py"), std::ios::app) << "# changed\n";
  liveTo(*life, 80);
  EXPECT_EQ(life->unanswered(), "") << "it runs as it was";
  killProgram(*life);
  life->step();
  EXPECT_NE(life->unanswered().find("is no longer the one that was read"), std::string::npos) << life->unanswered();
}

TEST(ChildRobot, TheFolderThatWasNamedLastIsTheOneThatIsMeant) {
  const ProgramHouse house(R"(["python3", "robot.py"])", "from rules import serve\nserve()\n");
  std::string rules = kCliff;
  rules.replace(rules.find("surefoot_child.serve("), std::string::npos, "def serve(): surefoot_child.serve(Cliff())\n");
  std::ofstream(house.folder.file("rules.py")) << rules;
  const std::string other = house.folder.file("other");
  std::filesystem::create_directory(other);
  for (const char* same : {"robot.toml", "robot.py"})
    std::filesystem::copy(house.folder.file(same), other + "/" + same);
  const auto stays = rules.find("self.at = [0, 0]");
  std::ofstream(other + "/rules.py") << rules.replace(stays, 16, "self.at = [5, 2]");
  const auto opened = house.registry.files->open(other + "/robot.toml");
  ASSERT_TRUE(opened);
  house.registry.programs->allow((*opened)->program);
  EXPECT_EQ((*opened)->entry.name, house.file->entry.name);
  EXPECT_NE((*opened)->program, house.file->program);
  const auto before = house.robot();
  const auto after = house.life();
  Random random(1);
  before->reset(random);
  after->begin();
  EXPECT_EQ(before->state()[0], 0);
  EXPECT_EQ(after->environment().state()[0], 5);
}

// A file of ours names where the robot lay. If another robot lies there now, its folder is nothing to this one.
TEST(ChildRobot, OnlyTheSameRobotsFolderIsTaken) {
  const ProgramHouse house;
  const std::string place = house.folder.file("robot.toml");
  auto registry = fullRegistry();
  const auto same = registry.files->add(house.file->text, "/nowhere/q.safetensors", place);
  ASSERT_TRUE(same) << same.error().message;
  EXPECT_EQ((*same)->program, house.file->program);
  std::string text = house.file->text;
  const auto other = registry.files->add(text.replace(text.find("python3"), 7, "python9"), "/nowhere/q", place);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_NE((*other)->program.find(" in /nowhere with"), std::string::npos) << (*other)->program;
}

// A test of the greedy policy may take minutes in a slow program; who ends the life does not wait for it.
TEST(ChildRobot, ATestThatIsGivenUpIsMadeAgain) {
  const auto with = [](ProgramHouse& house) {
    std::string text = house.file->text + "[[measure]]\nkey = \"at\"\nlast = \"column\"\n";
    const auto opened = house.registry.files->add(text.replace(text.find("max_steps"), 9, "test_every = 2\nmax_steps"),
                                                  house.folder.file("robot.toml"));
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().message);
    house.file = *opened;
    house.registry.programs->allowAll();
    return house.life();
  };
  ProgramHouse one, other;
  const auto undisturbed = with(one), stopped = with(other);
  std::atomic<bool> stop = false;
  for (int i = 0; i < 20'000; ++i) undisturbed->step(&stop);
  int given = 0;
  while (stopped->steps() < 20'000) {
    stop = stopped->steps() % 3 != 0;
    const std::int64_t before = stopped->steps();
    stopped->step(&stop);
    given += stopped->steps() == before;
    if (stopped->steps() == before) stop = false, stopped->step(&stop);
  }
  EXPECT_GT(given, 0);
  EXPECT_EQ(stopped->hash(), undisturbed->hash());
  ASSERT_GT(undisturbed->greedyTests().size(), 5u);
  ASSERT_EQ(stopped->greedyTests().size(), undisturbed->greedyTests().size());
  for (std::size_t i = 0; i < stopped->greedyTests().size(); ++i)
    EXPECT_EQ(stopped->greedyTests()[i].reward, undisturbed->greedyTests()[i].reward);
}

TEST(ChildRobot, WhatItsFormulasMakeOfItIsANumberOrTheEpisodeIsCutOff) {
  const ProgramHouse house;
  const auto robotWith = [&](const std::string& what, const std::string& with) {
    std::string text = house.file->text;
    const auto spec = robotOf(text.replace(text.find(what), what.size(), with));
    house.registry.programs->allowAll();
    return ChildRobot(spec, programOf(*spec, house.file->home.substr(0, house.file->home.rfind('/'))),
                      house.file->home.substr(0, house.file->home.rfind('/')), house.registry.programs);
  };
  for (const auto& [what, with] : {std::pair{"value = -1\n", "value = \"1 / (child.column - child.column)\"\n"},
                                   {"[[ending]]\n",
                                    "[[state]]\nkey = \"lost\"\nrange = [0, 9]\nresolution = 1\n"
                                    "value = \"sqrt(-1 - child.column)\"\n[[ending]]\n"}}) {
    ChildRobot robot = robotWith(what, with);
    Random random(1);
    for (int episode = 1; episode <= 100; ++episode) {
      EXPECT_EQ(robot.failure(), "");
      robot.reset(random);
      const Outcome outcome = robot.step(0);
      EXPECT_EQ(outcome.ending, Ending::Truncated);
      EXPECT_TRUE(std::isfinite(outcome.reward));
      for (const double x : robot.state()) EXPECT_TRUE(std::isfinite(x));
      EXPECT_EQ(robot.cutOffs().all, episode);
    }
    EXPECT_NE(robot.failure().find("came to a number that is none"), std::string::npos) << robot.failure();
  }
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
  EXPECT_FALSE(isAnyAlive(id));
}

}  // namespace surefoot
