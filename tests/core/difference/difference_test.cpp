// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/difference.h"

#include <fmt/format.h>

#include <fstream>

#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

class Records : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) const {
    const std::string path = folder_.file(name);
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  std::string journal(const std::string& name, const std::vector<Assignment>& assignments,
                      const std::vector<CommandText>& commands, std::int64_t steps = 2000) const {
    Configuration c = pendulumConfiguration(r_, "epsilon-greedy", assignments);
    c.episodes = 1000;
    c.commands = commands;
    const auto life = makeLife(r_, c, 0, false, steps);
    while (!(*life)->finished()) (*life)->step();
    return write(name, journalOf(c, summarise(**life, 0, 0.0)));
  }
  std::string checkpoint(const std::string& name, const std::vector<Assignment>& assignments,
                         std::int64_t steps) const {
    Configuration c = pendulumConfiguration(r_, "epsilon-greedy", assignments);
    c.episodes = 1000;
    const auto life = lifeOf(r_, c);
    life->keepInputs();
    while (life->steps() < steps) life->step();
    return write(name, checkpointOf(*life, c, false).write());
  }
  RecordDifference differ(const std::string& a, const std::string& b) const {
    auto found = differenceOf(r_, a, b);
    EXPECT_TRUE(found) << found.error().message;
    return found ? std::move(*found) : RecordDifference{};
  }
  std::string refusal(const std::string& a, const std::string& b) const {
    const auto found = differenceOf(r_, a, b);
    EXPECT_FALSE(found);
    return found ? "" : found.error().message;
  }
  Registry r_ = fullRegistry();
  Folder folder_;
};

}  // namespace

TEST_F(Records, APushAtStep500IsWhereTwoJournalsPart) {
  const std::string a = journal("a", {}, {}), b = journal("b", {}, {{500, "push", "0.05"}});
  const RecordDifference d = differ(a, b);
  ASSERT_EQ(d.told.size(), 1u);
  EXPECT_EQ(d.told[0].step, 500);
  EXPECT_EQ(d.told[0].first, "nothing");
  EXPECT_EQ(d.told[0].second, "push = 0.05");
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->step, 500);
  EXPECT_EQ(d.same, 500);
  const auto life = lifeOf(r_, pendulumConfiguration(r_));
  std::size_t at = 0;
  while (life->environment().task().state[at].key != d.parting->what) ++at;
  const auto state = [&](double push) {
    const auto one = lifeOf(r_, pendulumConfiguration(r_));
    while (one->steps() < 500) one->step();
    if (push != 0.0) one->push(push);
    one->step();
    return fmt::format("{}", one->environment().state()[at]);
  };
  EXPECT_EQ(d.parting->first, state(0.0)) << "the state after step 500";
  EXPECT_EQ(d.parting->second, state(0.05));
  const RecordDifference back = differ(b, a);
  EXPECT_EQ(back.parting->first, d.parting->second);
}

TEST_F(Records, EqualOnesAreTheSame) {
  const std::string a = journal("a", {}, {{500, "push", "0.05"}}), b = journal("b", {}, {{500, "push", "0.05"}});
  const RecordDifference d = differ(a, b);
  EXPECT_FALSE(d.differ());
  EXPECT_EQ(d.same, 2000);
  EXPECT_FALSE(differ(checkpoint("c", {}, 700), checkpoint("d", {}, 700)).differ());
}

// Another ε explores at another step: the first draw between the two changes an action.
TEST_F(Records, AnotherSettingIsToldAndTheFirstOtherActionFound) {
  const RecordDifference d = differ(journal("a", {}, {}), journal("b", {{"policy.epsilon", "0.5"}}, {}));
  ASSERT_EQ(d.told.size(), 1u);
  EXPECT_EQ(d.told[0].what, "policy.epsilon");
  EXPECT_EQ(d.told[0].first, "0.05");
  EXPECT_EQ(d.told[0].second, "0.5");
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->what, "action");
  EXPECT_NE(d.parting->first.find("N m"), std::string::npos) << d.parting->first;
  EXPECT_LT(d.parting->step, 100);
}

// The reward of a fall is another one: the first fall is where they part.
TEST_F(Records, AnotherRewardPartsThemAtTheFirstFall) {
  const RecordDifference d = differ(journal("a", {}, {}), journal("b", {{"environment.fall_reward", "-200"}}, {}));
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->what, "reward of the episode so far");
  const auto life = lifeOf(r_, pendulumConfiguration(r_));
  while (life->log().totals().falls == 0) life->step();
  EXPECT_EQ(d.parting->step, life->steps() - 1);
  EXPECT_EQ(d.parting->episode, life->log().totals().episodes);
}

TEST_F(Records, WhatChangesNothingLeavesAllStepsTheSame) {
  const RecordDifference d = differ(journal("a", {}, {}), journal("b", {{"policy.temperature", "3"}}, {}));
  EXPECT_EQ(d.told.size(), 1u);
  EXPECT_FALSE(d.parting);
  EXPECT_EQ(d.same, 2000);
}

TEST_F(Records, TheShorterOneEnds) {
  const RecordDifference d = differ(journal("a", {}, {}, 800), journal("b", {}, {}));
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->step, 800);
  EXPECT_EQ(d.parting->what, "steps of the life");
  EXPECT_EQ(d.parting->second, "2000");
}

TEST_F(Records, OtherTasksHaveNoStepInCommon) {
  Configuration c = *configure(r_, {.environment = "cliff"}, {});
  c.episodes = 3;
  const auto lives = runLives(r_, c, {});
  const RecordDifference d = differ(journal("a", {}, {}), write("b", journalOf(c, lives->front())));
  EXPECT_EQ(d.told[0].what, "environment");
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->what, "state variables");
  EXPECT_EQ(d.parting->step, 0);
}

TEST_F(Records, CheckpointsPartWhereTheirLivesDoOrInANumber) {
  const std::string a = checkpoint("a", {}, 700);
  const RecordDifference lived = differ(a, checkpoint("b", {{"policy.epsilon", "0.5"}}, 700));
  ASSERT_TRUE(lived.parting);
  EXPECT_EQ(lived.parting->what, "action");
  EXPECT_EQ(lived.note, "");
  const RecordDifference later = differ(a, checkpoint("c", {}, 900));
  ASSERT_TRUE(later.parting);
  EXPECT_EQ(later.parting->step, 700);
  auto file = *readQFile(a);
  TensorFile other = *file;
  for (Tensor& t : other.tensors)
    if (t.name == "q.weights") t.bytes[8 * 5 + 6] = static_cast<char>(t.bytes[8 * 5 + 6] ^ 1);
  seal(other);
  const RecordDifference number = differ(a, write("d", other.write()));
  ASSERT_TRUE(number.parting);
  EXPECT_EQ(number.parting->what, "q.weights[5]");
}

TEST_F(Records, LogsPartInACell) {
  const std::string head = "life,episode,transitions,reward,falls\n", rows = "0,1,100,-100,1\n0,2,120,99.5,0\n";
  const std::string a = write("a.csv", head + rows + "1,1,7,3,0\n");
  EXPECT_FALSE(differ(a, write("b.csv", head + rows + "1,1,7,3,0\n")).differ());
  EXPECT_EQ(differ(a, a).same, 3);
  RecordDifference d = differ(a, write("c.csv", head + "0,1,100,-100,1\n0,2,120,99.25,1\n1,1,7,3,0\n"));
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->what, "reward");
  EXPECT_EQ(d.parting->first, "99.5");
  EXPECT_EQ(d.parting->second, "99.25");
  EXPECT_EQ(d.parting->life, 0);
  EXPECT_EQ(d.parting->episode, 2);
  EXPECT_EQ(d.same, 1);
  d = differ(a, write("d.csv", head + rows));
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->second, "ends");
  EXPECT_EQ(d.parting->life, 1);
  d = differ(a, write("e.csv", "life,episode,transitions,reward,ending\n" + rows));
  ASSERT_TRUE(d.parting);
  EXPECT_EQ(d.parting->what, "column");
  EXPECT_EQ(d.parting->second, "ending");
}

TEST_F(Records, WhatCannotBeComparedIsASentence) {
  const std::string log = write("a.csv", "life,episode,falls\n0,1,2\n"), j = journal("j", {}, {}, 100);
  const std::string c = checkpoint("c", {}, 100);
  EXPECT_NE(refusal(log, j).find("only two of a kind"), std::string::npos);
  EXPECT_NE(refusal(j, c).find("is a checkpoint"), std::string::npos);
  EXPECT_NE(refusal(log, folder_.file("none")).find("none"), std::string::npos);
  EXPECT_NE(refusal(write("p.txt", "a poem of some length"), log).find("p.txt: it is no journal"), std::string::npos);
  EXPECT_NE(refusal(log, write("s.csv", "life,episode,falls\n0,1\n")).find("line 2 is no row"), std::string::npos);
  EXPECT_NE(refusal(write("t.csv", "life,episode,falls\n0,x,3\n"), log).find("line 2"), std::string::npos);
  EXPECT_NE(refusal(log, write("u.csv", "life,episode,falls\n0,1,2")).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(j, write("k", "{\"surefoot_journal\": \"1.0\"}\n")).find("k: "), std::string::npos);
  const std::atomic<bool> interrupted = true;
  const auto stopped = differenceOf(r_, j, journal("l", {{"policy.epsilon", "0.5"}}, {}), &interrupted);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

}  // namespace surefoot
