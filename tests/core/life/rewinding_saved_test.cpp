// SPDX-License-Identifier: GPL-3.0-or-later
// Lives with rewinds as files and in plans.
#include "core/plans/plan.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "tests/core/life/ice.h"

namespace surefoot {

// Saved right after a rewind and elsewhere, switched on and changed in the middle of an episode, with pushes.
TEST(Rewinding, ASavedLifeGoesOnTheSame) {
  Told told;
  const Registry r = withIce(told);
  for (const char* environment : {"ice", "pendulum"}) {
    Configuration c = rewinding(r, environment, "0", "2");
    c.commands = {
        {40, "life.rewind", "5"}, {200, "push", "0.01"}, {300, "life.rewinds", "4"}, {900, "life.rewind", "9"}};
    const auto whole = lifeOf(r, c);
    livePart(*whole);
    ASSERT_GT(whole->log().totals().rewinds, 50);
    const auto first = lifeOf(r, c);
    first->keepInputs();
    int saved = 0;
    for (int rewinds = 0; !first->finished() && saved < 40; first->step()) {
      const bool isNew = first->inEpisode() && first->log().current().rewinds > rewinds;
      rewinds = first->inEpisode() ? first->log().current().rewinds : 0;
      if (!isNew && first->steps() % 97 != 0) continue;
      ++saved;
      auto file = TensorFile::parse(checkpointOf(*first, c, false).write(), "c.safetensors");
      ASSERT_TRUE(file);
      auto resumed = resume(r, std::make_shared<const TensorFile>(std::move(*file)), {});
      ASSERT_TRUE(resumed) << resumed.error().message;
      EXPECT_EQ(resumed->life->environment().pose(), first->environment().pose());
      livePart(*resumed->life);
      EXPECT_EQ(resumed->life->hash(), whole->hash()) << environment << " from step " << first->steps();
      EXPECT_EQ(resumed->life->log().totals().rewinds, whole->log().totals().rewinds);
    }
    EXPECT_EQ(saved, 40);
  }
}

TEST(Rewinding, AJournalIsLivedAgain) {
  const Registry r = fullRegistry();
  Configuration c = rewinding(r, "pendulum", "20", "2");
  c.episodes = 60;
  c.commands = {{500, "push", "0.05"}, {2000, "life.rewind", "5"}};
  const auto lives = runLives(r, c, {});
  ASSERT_TRUE(lives);
  EXPECT_GT(lives->front().totals.rewinds, 0);
  const auto journal = parseJournal(r, journalOf(c, lives->front()), "j");
  ASSERT_TRUE(journal) << journal.error().message;
  const auto again = replay(r, *journal, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->hash, lives->front().hash);
}

TEST(Rewinding, APreLearningHasItAlone) {
  const Registry r = fullRegistry();
  const auto plan = parsePlan(r,
                              "[pre-learning]\nscenario = \"2\"\nminutes = 1\nset.life.rewind = 20\n"
                              "[[condition]]\nminutes = 1\nscenario = \"actual\"\n",
                              "p.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  const Condition& c = plan->conditions.front();
  EXPECT_EQ(c.configuration.parameters.get("life.rewind"), 0.0);
  ASSERT_TRUE(c.preLearning);
  EXPECT_EQ(c.preLearning->configuration.parameters.get("life.rewind"), 20.0);
  EXPECT_NE(c.preLearning->text.find("life.rewind=20"), std::string::npos) << c.preLearning->text;
  EXPECT_EQ(c.preLearning->text.find("life.rewinds"), std::string::npos);
}

}  // namespace surefoot
