// SPDX-License-Identifier: GPL-3.0-or-later
// A Q-function of a file as guardian: it acts, it goes along wherever a life goes, and its absence is told.
#include <filesystem>

#include "core/files/whole_file.h"
#include "core/plans/plan.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"
#include "core/saved/teacher_file.h"
#include "core/store/store.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

class Teacher : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto c = configure(registry(), {}, {});
    ASSERT_TRUE(c) << c.error().message;
    c->episodes = 300;
    const auto life = lived(*c);
    ASSERT_TRUE(writeWhole("q", path(), qFileOf(*life, *c).write()));
  }

  static const Registry& registry() {
    static const Registry all = fullRegistry();
    return all;
  }
  /// Of this process: each test is one, and they run at once.
  static const Folder& folder() {
    static const Folder one;
    return one;
  }
  static std::string path() { return folder().file("teacher.safetensors"); }

  static std::unique_ptr<Life> lived(const Configuration& c) {
    auto life = makeLife(registry(), c, 0, true);
    EXPECT_TRUE(life) << (life ? "" : life.error().message);
    (*life)->keepInputs();
    while (!(*life)->finished()) (*life)->step();
    return std::move(*life);
  }

  /// The pendulum, learning its risk, guarded by the file from this risk on.
  static Configuration guarded(const char* limit, int episodes = 60) {
    std::vector<Assignment> assignments = {
        {"risk.learn", "on"}, {"policy.guardian", path()}, {"policy.guardian_limit", limit}};
    auto teacher = takeTeacher(assignments, "");
    EXPECT_TRUE(teacher) << (teacher ? "" : teacher.error().message);
    auto c = configure(registry(), {}, assignments);
    EXPECT_TRUE(c) << (c ? "" : c.error().message);
    c->teacher = *teacher;
    c->episodes = episodes;
    return *c;
  }
};

}  // namespace

TEST_F(Teacher, ActsWhereTheRiskIsHighAndIsCounted) {
  const auto never = lived(guarded("1")), often = lived(guarded("0.02"));
  EXPECT_EQ(never->agent().guarded(), 0) << "no risk is above 1";
  EXPECT_GT(often->agent().guarded(), 0);
  EXPECT_LT(often->agent().guarded(), often->steps());
  EXPECT_LT(often->log().totals().falls, never->log().totals().falls);
}

TEST_F(Teacher, ChoosesWhatItsOwnValuesSay) {
  const Configuration c = guarded("0.02");
  const auto environment = makeEnvironment(registry(), c);
  auto made = makeTeacher(registry(), *c.teacher, (*environment)->task());
  ASSERT_TRUE(made) << made.error().message;
  const std::vector<double> state = {0.1, -0.4, 0.3};
  std::vector<double> q(5);
  (*made)->values().evaluate(state, Layer::Sum, q);
  const Guardians guardians(**environment, std::move(*made));
  EXPECT_EQ(guardians.act(GuardedBy::QFunction, state), std::max_element(q.begin(), q.end()) - q.begin());
}

TEST_F(Teacher, GoesAlongInALifesFile) {
  const Configuration c = guarded("0.02");
  const auto whole = lived(c);
  auto first = makeLife(registry(), c, 0, true);
  (*first)->keepInputs();
  for (int i = 0; i < 700; ++i) (*first)->step();
  auto file = TensorFile::parse(checkpointOf(**first, c, true).write(), "life.surefoot");
  ASSERT_TRUE(file) << file.error().message;
  auto checked = checkedQFile(std::move(*file));
  ASSERT_TRUE(checked) << checked.error().message;
  std::filesystem::rename(path(), path() + ".away");
  auto resumed = resume(registry(), *checked, {});
  std::filesystem::rename(path() + ".away", path());
  ASSERT_TRUE(resumed) << resumed.error().message;
  while (!resumed->life->finished()) resumed->life->step();
  EXPECT_EQ(resumed->life->hash(), whole->hash());
  EXPECT_EQ(resumed->life->agent().guarded(), whole->agent().guarded());
}

TEST_F(Teacher, IsTakenOutOfWhatALifeLearned) {
  const Configuration c = guarded("0.02", 5);
  const auto file = qFileOf(*lived(c), c);
  const auto again = configurationOf(registry(), file);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->parameters.get("policy.guardian"), 0.0);
}

TEST_F(Teacher, IsNamedInAJournalWithItsContent) {
  const Configuration c = guarded("0.02");
  const auto life = lived(c);
  const std::string name = folder().file("guarded.jsonl");
  const std::string text = journalOf(c, summarise(*life, 0, 0.0));
  const auto journal = parseJournal(registry(), text, name);
  ASSERT_TRUE(journal) << journal.error().message;
  const auto again = replay(registry(), *journal, {});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->hash, life->hash());

  std::string other = text;
  const auto at = other.find("\"content\":\"") + 11;
  other[at] = other[at] == '0' ? '1' : '0';
  const auto refused = parseJournal(registry(), other, name);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("was guarded by"), std::string::npos) << refused.error().message;
}

TEST_F(Teacher, IsWrittenInAPlanByItsFileAndKeptInTheStore) {
  const std::string file = folder().file("guarded.toml");
  ASSERT_TRUE(writeWhole("plan", file, R"(
lives = 2
[base]
episodes = 20
set.risk.learn = "on"
[[condition]]
name = "guarded"
set.policy.guardian = "teacher.safetensors"
set.policy.guardian_limit = 0.02
)"));
  const auto plan = readPlan(registry(), file, {});
  ASSERT_TRUE(plan) << plan.error().message;
  const Configuration& c = plan->conditions[0].configuration;
  ASSERT_TRUE(c.teacher);
  EXPECT_NE(plan->conditions[0].text.find(" guardian=" + contentOf(*c.teacher)), std::string::npos);
  const auto stored = planToStore(registry(), *plan);
  ASSERT_TRUE(stored) << stored.error().message;
  const std::string place = folder().file("guarded.sqlite");
  const auto store = Store::create(place, *stored);
  ASSERT_TRUE(store) << store.error().message;
  const auto again = planFromStore(registry(), *store);
  ASSERT_TRUE(again) << again.error().message;
  ASSERT_TRUE(again->conditions[0].configuration.teacher);
  EXPECT_EQ(lived(again->conditions[0].configuration)->hash(), lived(c)->hash());
}

TEST_F(Teacher, IsRefusedWhereItIsMissingOrOfAnotherTask) {
  Configuration without = guarded("0.02", 1);
  without.teacher = nullptr;
  const auto missing = makeLife(registry(), without, 0, false);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("name its file, policy.guardian = FILE"), std::string::npos);

  auto compass = configure(registry(), {.environment = "compass"}, {{"risk.learn", "on"}});
  compass->episodes = 1;
  compass->teacher = guarded("0.02", 1).teacher;
  const auto other = makeLife(registry(), *compass, 0, false);
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message.find("teacher.safetensors"), std::string::npos) << other.error().message;

  std::vector<Assignment> none = {{"policy.guardian", "nowhere.safetensors"}};
  EXPECT_FALSE(takeTeacher(none, ""));
}

}  // namespace surefoot
