// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds of robots from files: the same bits fresh and used, mechanics by hand, LEO's own controller.
#include <numbers>

#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "tests/folder.h"
#include "tests/full_registry.h"
#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

constexpr const char* kRobots[] = {"acrobot", "ball-beam", "biped",    "cart-pole", "compass",
                                   "hopper",  "leo",       "pendulum", "segway"};

/// Rewards and states of an episode of random actions.
std::uint64_t hashOfEpisode(Robot& robot, int episode) {
  Random random(static_cast<std::uint64_t>(episode) + 1);
  Hash64 hash;
  robot.reset(random);
  const auto actions = static_cast<double>(robot.task().actions.size());
  for (int step = 0; step < 60; ++step) {
    const Outcome outcome = robot.step(static_cast<Action>(random.uniform() * actions));
    hash.add(outcome.reward);
    for (const double x : robot.state()) hash.add(x);
    if (outcome.ending != Ending::None) break;
  }
  return hash.value();
}

/// A robot of the least text: a mass that hangs, slides or turns.
std::string text(const std::string& bodies, const std::string& rest = "") {
  return "surefoot = \"robot 1\"\nname = \"test\"\nstep_time = 0.01\nsubsteps = 10\nmax_steps = 100000\n" + bodies +
         "[actuator.motor]\njoint = \"hinge\"\nlevels = [-1, 0, 1]\n" + rest +
         "[[reward]]\nname = \"time\"\nvalue = -1\n";
}

const std::string kPendulum =
    "[body.rod]\nmass = 2\ninertia = 0.1\ncentre = [0, -0.5]\n[ground]\ntype = \"none\"\n"
    "[joint.hinge]\nbetween = [\"world\", \"rod\"]\n";
const std::string kAngles =
    "[[state]]\nkey = \"angle\"\nvalue = \"hinge.angle\"\nrange = [-4, 4]\n[[state]]\nkey = \"rate\"\n"
    "value = \"hinge.rate\"\nrange = [-20, 20]\n";

}  // namespace

TEST(RobotWorlds, AreTheSameFreshAndUsed) {
  for (const char* name : kRobots) {
    const auto spec = robotOf(robotText(name));
    ASSERT_TRUE(spec) << name;
    Robot used(spec);
    for (int episode = 0; episode < 60; ++episode) {
      Robot fresh(spec);
      ASSERT_EQ(hashOfEpisode(used, episode), hashOfEpisode(fresh, episode)) << name << ", episode " << episode;
    }
  }
}

TEST(RobotWorlds, ARodSwingsAsTheEquationSays) {
  const auto spec = robotOf(text(kPendulum, kAngles + "[start]\n\"hinge.angle\" = 0.05\n"));
  ASSERT_TRUE(spec);
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  // ω² = m g l / (I + m l²)
  const double period = 2 * std::numbers::pi / std::sqrt(2 * 9.81 * 0.5 / (0.1 + 2 * 0.25));
  int crossings = 0;
  double last = robot.state()[0], first = 0.0, now = 0.0;
  for (int step = 0; step < 1000; ++step) {
    robot.step(1);
    const double angle = robot.state()[0];
    if (last > 0 && angle <= 0) {
      now = (step + last / (last - angle)) * 0.01;
      if (crossings++ == 0) first = now;
    }
    last = angle;
  }
  ASSERT_GT(crossings, 4);
  EXPECT_NEAR((now - first) / (crossings - 1), period, 0.005 * period);
}

TEST(RobotWorlds, AMotorsTorqueFrictionAndDampingAreThoseOfTheFile) {
  const auto rateAfter = [&](const std::string& joint, int action) {
    const auto spec = robotOf(
        text("gravity = 0\n[body.rod]\nmass = 2\ninertia = 0.5\n[ground]\ntype = \"none\"\n[joint.hinge]\nbetween = "
             "[\"world\", \"rod\"]\n" +
                 joint,
             kAngles));
    if (!spec) return 0.0;
    Robot robot(spec);
    Random random(1);
    robot.reset(random);
    for (int step = 0; step < 100; ++step) robot.step(action);
    return robot.state()[1];
  };
  EXPECT_NEAR(rateAfter("", 2), 2.0, 1e-3);                              // T t/I
  EXPECT_NEAR(rateAfter("friction = 0.25\n", 2), 1.5, 1e-3);             // (T − F) t/I
  EXPECT_NEAR(rateAfter("friction = 2\n", 2), 0.0, 1e-6);                // it holds
  EXPECT_NEAR(rateAfter("damping = 1\n", 2), 1 - std::exp(-2.0), 2e-3);  // T/D (1 − e^(−D t/I))
  EXPECT_NEAR(rateAfter("armature = 0.5\n", 2), 1.0, 1e-3);              // T t/(I + J)
  EXPECT_NEAR(rateAfter("", 0), -2.0, 1e-3);
}

TEST(RobotWorlds, ASpringSlidesAsTheEquationSays) {
  const auto spec = robotOf(
      "surefoot = \"robot 1\"\nname = \"spring\"\nstep_time = 0.01\nsubsteps = 10\n[body.mass]\nmass = 2\nrotates = "
      "false\n[ground]\ntype = \"none\"\n[joint.rail]\ntype = \"prismatic\"\nbetween = [\"world\", "
      "\"mass\"]\nstiffness = "
      "50\n[actuator.motor]\ntype = \"force\"\njoint = \"rail\"\nlevels = [0, 10]\n[[state]]\nkey = \"x\"\nvalue = "
      "\"mass.x\"\nrange = [-1, 1]\n[start]\n\"rail.position\" = 0.1\n[[reward]]\nname = \"time\"\nvalue = -1\n");
  ASSERT_TRUE(spec);
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  EXPECT_NEAR(robot.state()[0], 0.1, 1e-6);
  for (int step = 1; step <= 60; ++step) {
    robot.step(0);
    EXPECT_NEAR(robot.state()[0], 0.1 * std::cos(5 * 0.01 * step), 2e-3) << step;  // ω = √(k/m)
  }
}

TEST(RobotWorlds, LeoWalksWithItsHandMadeController) {
  const auto spec = robotOf(robotText("leo"));
  ASSERT_TRUE(spec);
  Robot robot(spec);
  ASSERT_TRUE(robot.task().handMade);
  EXPECT_EQ(robot.task().actions.size(), 343u);
  Random random(1);
  robot.reset(random);
  double reward = 0.0;
  Outcome outcome;
  int steps = 0;
  for (; outcome.ending == Ending::None; ++steps) reward += (outcome = robot.step(kHandMade)).reward;
  EXPECT_EQ(steps, 750);
  EXPECT_EQ(outcome.event, Event::None);
  EXPECT_NEAR(reward, 4000, 100);               // RESULTS.md: 3,945 to 4,044
  EXPECT_NEAR(robot.measures()[0], 10.6, 0.2);  // m: 10.5 to 10.7
  EXPECT_EQ(robot.measures()[1], 49);
  EXPECT_LT(robot.world().jointSeparation(), 1e-4);
}

TEST(RobotWorlds, RaysEventsAndMemoriesDoWhatTheyAreFor) {
  const auto spec = robotOf(
      "surefoot = \"robot 1\"\nname = \"faller\"\nstep_time = 0.1\nsubsteps = 10\n[body.ball]\nat = [0, 2]\nmass = "
      "1\ninertia = 0.1\nshape = [{ circle = 0.1 }]\n[point.centre]\non = \"ball\"\n[ray.down]\nfrom = "
      "\"centre\"\nangle = \"-pi / 2\"\nlength = 5\n[actuator.lift]\ntype = \"force\"\npoint = "
      "\"centre\"\ndirection = [0, 1]\nlevels = [0, 9.81]\n[[memory]]\nkey = \"hits\"\nstart = 0\neach = \"hits + "
      "ball.touches\"\n[[state]]\nkey = \"gap\"\nvalue = \"down.distance\"\nrange = [0, 5]\n[[state]]\nkey = "
      "\"count\"\nvalue = \"hits\"\nrange = [0, 100]\n[[event]]\nkind = \"fall\"\nwhen = \"ball.touches && hits == "
      "1\"\n[[reward]]\nname = \"gap\"\npotential = \"gap\"\n");
  ASSERT_TRUE(spec);
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  EXPECT_NEAR(robot.state()[0], 2.0, 1e-3);
  for (int step = 0; step < 5; ++step) EXPECT_NEAR(robot.step(1).reward, 0.0, 1e-3) << "it hovers";
  int falls = 0;
  double reward = 0.0;
  for (int step = 0; step < 20; ++step) {
    const Outcome outcome = robot.step(0);
    falls += outcome.event == Event::Fall;
    reward += outcome.reward;
    EXPECT_EQ(outcome.ending, Ending::None) << "an event ends nothing";
  }
  EXPECT_EQ(falls, 1);
  EXPECT_NEAR(robot.state()[0], 0.1, 0.02);
  EXPECT_NEAR(reward, -1.9, 0.02) << "a potential pays its change";
  EXPECT_GT(robot.state()[1], 5);
}

TEST(RobotWorlds, WhatAlwaysFliesApartStopsTheLifeWithItsParameter) {
  Registry registry = fullRegistry();
  const auto file = registry.files->add(text("[[parameter]]\nkey = \"slip\"\nvalue = 0\nrange = [0, 1]\n" + kPendulum,
                                             "effort = \"slip > 0 ? 1 / (hinge.angle - hinge.angle) : u\"\n" + kAngles),
                                        "test.toml");
  ASSERT_TRUE(file) << file.error().message;
  Names names;
  names.environment = (*file)->entry.name;
  auto configuration = configure(registry, names, {{"environment.slip", "0.5"}});
  ASSERT_TRUE(configuration) << configuration.error().message;
  configuration->episodes = 1000;
  const auto life = makeLife(registry, *configuration, 0, false);
  ASSERT_TRUE(life) << life.error().message;
  while (!(*life)->finished()) (*life)->step();
  EXPECT_TRUE((*life)->diverged());
  EXPECT_EQ((*life)->environment().cutOffs().all, 100);
  EXPECT_NE((*life)->divergence().find("environment.slip = 0.5"), std::string::npos) << (*life)->divergence();
}

TEST(RobotWorlds, WhatFliesApartIsCutOffAndCounted) {
  const auto spec = robotOf(text(kPendulum, "effort = \"1 / (hinge.angle - hinge.angle)\"\n" + kAngles));
  ASSERT_TRUE(spec);
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  const Outcome outcome = robot.step(0);
  EXPECT_EQ(outcome.ending, Ending::Truncated);
  EXPECT_EQ(outcome.event, Event::None);
  EXPECT_EQ(robot.cutOffs().all, 1);
  for (const double x : robot.state()) EXPECT_TRUE(std::isfinite(x));
}

// What ends a life after a hundred such episodes counts those before it was saved, too.
TEST(RobotWorlds, ASavedLifeRemembersHowOftenItWasCutOff) {
  Registry registry = fullRegistry();
  const auto file =
      registry.files->add(text(kPendulum, "effort = \"1 / (hinge.angle - hinge.angle)\"\n" + kAngles), "t");
  ASSERT_TRUE(file) << file.error().message;
  Names names;
  names.environment = (*file)->entry.name;
  auto configuration = configure(registry, names, {});
  ASSERT_TRUE(configuration) << configuration.error().message;
  configuration->episodes = 1000;
  auto life = makeLife(registry, *configuration, 0, false);
  ASSERT_TRUE(life) << life.error().message;
  (*life)->keepInputs();
  for (int i = 0; i < 37; ++i) (*life)->step();
  const auto saved = std::make_shared<const TensorFile>(checkpointOf(**life, *configuration, false));
  auto resumed = resume(registry, saved, {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  for (Life* one : {life->get(), resumed->life.get()}) {
    while (!one->finished()) one->step();
    EXPECT_EQ(one->log().totals().episodes, 100);
    EXPECT_EQ(one->environment().cutOffs().all, 100);
  }
  EXPECT_EQ(resumed->life->hash(), (*life)->hash());
}

TEST(RobotWorlds, AFormulaThatComesToNoNumberCutsTheEpisodeOff) {
  const std::string reward = "[[reward]]\nname = \"lost\"\nvalue = \"1 / (step - 3)\"\n";
  const std::string state = "[[state]]\nkey = \"lost\"\nrange = [0, 9]\nwidth = 1\nvalue = \"sqrt(2.5 - step)\"\n";
  const std::string measure = "[[measure]]\nkey = \"lost\"\ntitle = \"Lost\"\nlast = \"wrap(1, 3 - step)\"\n";
  for (const std::string& lost : {reward, state, measure}) {
    const auto spec = robotOf(text(kPendulum, kAngles + lost));
    ASSERT_TRUE(spec);
    Robot robot(spec);
    Random random(1);
    for (int episode = 1; episode <= 100; ++episode) {
      EXPECT_EQ(robot.failure(), "");
      robot.reset(random);
      Outcome outcome;
      for (int step = 1; step <= 3; ++step) {
        EXPECT_EQ(outcome.ending, Ending::None);
        outcome = robot.step(0);
        EXPECT_TRUE(std::isfinite(outcome.reward));
        for (const double x : robot.state()) EXPECT_TRUE(std::isfinite(x));
      }
      EXPECT_EQ(outcome.ending, Ending::Truncated);
      EXPECT_EQ(robot.cutOffs().all, episode);
    }
    EXPECT_NE(robot.failure().find(" lost came to a number that is none"), std::string::npos) << robot.failure();
  }
}

// As many rewards as a robot may have, and those that an agent adds.
TEST(RobotWorlds, EightRewardsAreSplitAndShaped) {
  std::string rewards;
  for (int i = 1; i < kMaxTaskTerms; ++i) rewards += "[[reward]]\nname = \"r" + std::to_string(i) + "\"\nvalue = 0.5\n";
  const Folder folder;
  const std::string file = folder.file("eight-rewards.toml");
  ASSERT_TRUE(writeWhole("robot", file, text(kPendulum, kAngles + rewards)));
  const Registry registry = fullRegistry();
  auto c = configure(registry, {.environment = file, .agent = "sarsa-2q"},
                     {{"shaping.rewards", "all"}, {"agent.budget", "on"}, {"risk.learn", "on"}});
  ASSERT_TRUE(c) << c.error().message;
  c->minutes = 0.1;
  const auto life = makeLife(registry, *c, 0, false);
  ASSERT_TRUE(life) << life.error().message;
  while (!(*life)->finished()) (*life)->step();
  EXPECT_FALSE((*life)->diverged());
}

}  // namespace surefoot
