// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <filesystem>

#include "core/environment_programs.h"
#include "tests/ui/experiment/experiment_window.h"
#include "tests/ui/session/learn_and_answer.h"

namespace surefoot {

TEST(ExperimentPage, TheResultsAreThoseOfAHeadlessRun) {
  ExperimentWindow p;
  p.runToTheEnd();
  const auto plan = parsePlan(p.registry, kPlan, "plan.toml", {});
  const std::string other = p.folder.filePath("headless.sqlite").toStdString();
  auto store = Store::create(other, *planToStore(p.registry, *plan));
  ASSERT_TRUE(runPlan(p.registry, *plan, *store, {}));
  const auto shown = Store::open(p.experiment().storePath());
  ASSERT_TRUE(shown) << shown.error().message;
  EXPECT_EQ(*shown->contentHash(), *store->contentHash());
}

TEST(ExperimentPage, OpensResultsMadeWithoutAWindow) {
  ExperimentWindow p;
  p.runToTheEnd();
  const QString results = p.folder.filePath("results.sqlite");
  ASSERT_TRUE(QFile::copy(QString::fromStdString(p.experiment().storePath()), results));
  QString said;
  QObject::connect(&p.page, &ExperimentPage::refused, [&](const QString& s) { said = s; });
  const QString store = QString::fromStdString(p.experiment().storePath());
  p.page.startAgain();
  EXPECT_FALSE(p.experiment().view());
  EXPECT_TRUE(said.contains(store)) << "nobody is left without knowing where his lives are: " << said.toStdString();
  p.page.open(results);
  ASSERT_TRUE(p.experiment().view());
  EXPECT_EQ(p.experiment().state(), State::Complete);
  EXPECT_EQ(p.experiment().title(), "Two walks");
  EXPECT_FALSE(p.experiment().canRun()) << "nothing is missing";
}

TEST(ExperimentPage, AStoreThatIsOpenedAgainGoesOnToTheSameContent) {
  const auto plan = parsePlan(fullRegistry(), kLongPlan, "plan.toml", {});
  QTemporaryDir folder;
  const QString kept = folder.filePath("kept.sqlite");
  {
    ExperimentWindow p(kLongPlan);
    p.page.runOrPause();
    ASSERT_TRUE(p.waitFor([&] { return p.experiment().falls() > 50; }, 30'000));
    const QString store = QString::fromStdString(p.experiment().storePath());
    p.page.startAgain();  // which keeps what was in hand
    ASSERT_TRUE(p.waitFor([&] { return QFile::exists(store + ".lives") && !QFile::exists(store + "-lock"); }, 30'000));
    ASSERT_TRUE(QFile::copy(store, kept));
    ASSERT_TRUE(QDir().rename(store + ".lives", kept + ".lives"));
  }
  ExperimentWindow p;
  p.page.open(kept);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  EXPECT_EQ(p.experiment().state(), State::Paused);
  ASSERT_TRUE(p.experiment().canRun());
  EXPECT_TRUE(p.experiment().text().empty());
  p.runToTheEnd();
  EXPECT_FALSE(QFile::exists(kept + ".lives"));
  const std::string other = folder.filePath("headless.sqlite").toStdString();
  auto headless = Store::create(other, *planToStore(p.registry, *plan));
  ASSERT_TRUE(runPlan(p.registry, *plan, *headless, {.jobs = 2}));
  EXPECT_EQ(*Store::open(kept.toStdString())->contentHash(), *headless->contentHash());
}

TEST(ExperimentPage, AStoreOfAnotherVersionGoesOnOnlyIfThatIsWanted) {
  ExperimentWindow p;
  const std::string path = p.folder.filePath("other.sqlite").toStdString();
  const auto plan = parsePlan(p.registry, kPlan, "plan.toml", {});
  {
    auto store = Store::create(path, *planToStore(p.registry, *plan));
    ASSERT_TRUE(store->save({.life = 0, .episodes = 0, .diverged = {}, .livesVersion = 77, .program = "9.9"}, {}, {}));
  }
  p.page.open(QString::fromStdString(path));
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  const Status refused = p.experiment().run();
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("9.9"), std::string::npos) << refused.error().message;
  EXPECT_EQ(p.experiment().needs(), Experiment::Consent::OtherVersion);
  EXPECT_TRUE(p.experiment().run(true));
  EXPECT_TRUE(p.waitFor([&] { return p.experiment().state() == State::Complete; }, 60'000));
}

TEST(ExperimentPage, AsksBeforeARobotOfThePlanStartsItsProgram) {
  ExperimentWindow p;
  const std::string programs = std::string(SUREFOOT_SOURCE) + "/resources/robots/child";
  p.registry.programs->setModules(programs);
  std::filesystem::copy(programs, p.folder.filePath("car").toStdString());
  const std::string plan =
      "lives = 2\nreference = \"one\"\n[base]\nenvironment = \"car/car.toml\"\nepisodes = 2\n[[condition]]\n"
      "name = \"one\"\n[[condition]]\nname = \"two\"\npolicy = \"softmax\"\n";
  const QString path = p.folder.filePath("cars.toml");
  ASSERT_TRUE(writeWhole("plan", path.toStdString(), plan));
  p.page.open(path);
  ASSERT_TRUE(p.waitFor([&] { return !p.experiment().isOpening(); }));
  p.page.runOrPause();
  ASSERT_TRUE(answersOf(*p.window).contains("Allow it, and go on"));
  EXPECT_EQ(p.experiment().state(), State::Ready);
  EXPECT_TRUE(p.experiment().storePath().empty());
  answer(*p.window, "Allow it, and go on");
  EXPECT_TRUE(p.waitFor([&] { return p.experiment().state() == State::Complete; }, 60'000)) << p.refusal;
}

}  // namespace surefoot
