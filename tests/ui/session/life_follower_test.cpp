// SPDX-License-Identifier: GPL-3.0-or-later
// A checkpoint that another process writes again and again, looked at from the Live page.
#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <filesystem>

#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"
#include "tests/ui/session/learn_and_answer.h"
#include "ui/session/life_follower.h"

namespace surefoot {

namespace {

struct FollowedLife : Window {
  FollowedLife() : elsewhere(pendulumConfiguration(registry, "softmax")), path(folder.filePath("life.safetensors")) {
    elsewhere.seed = 7;
    other = std::move(*makeLife(registry, elsewhere, 0, false));
    other->keepInputs();
  }
  /// The other process: it lives on until so many episodes are over, and writes its checkpoint.
  void write(std::int64_t episodes) {
    while (other->log().totals().episodes < episodes) other->step();
    ASSERT_TRUE(writeWhole("checkpoint", path.toStdString(), checkpointOf(*other, elsewhere, false).write()));
  }
  bool shows(std::int64_t episodes) {
    return waitFor([&] { return session->life().isShown() && session->life().numbers().episodes == episodes; }, 20'000);
  }
  bool says(const char* words) {
    return waitFor([&] { return window->follower().text().contains(words); }, 20'000);
  }

  Configuration elsewhere;
  std::unique_ptr<Life> other;
  QTemporaryDir folder;
  QString path;
};

}  // namespace

TEST(LifeFollower, ShowsTheNewestStateOfTheFileAndWritesNothing) {
  FollowedLife w;
  learn(w, 30);
  const std::int64_t own = w.session->life().progress().episodes;
  w.window->follow(w.path);
  ASSERT_TRUE(w.says("not there yet"));
  EXPECT_EQ(w.session->life().progress().episodes, own) << "nothing is lost while one waits";
  w.write(40);
  ASSERT_TRUE(w.shows(40));
  EXPECT_TRUE(w.says("as of"));
  EXPECT_EQ(w.session->life().configuration().names.policy, "softmax");
  EXPECT_FALSE(w.session->life().running());
  EXPECT_TRUE(w.session->looking().demonstrating()) << "the body acts with these values";
  EXPECT_FALSE(w.session->life().unsaved());
  EXPECT_TRUE(w.session->life().file().path.isEmpty()) << "Save must not write over it";

  const auto& points = w.session->life().curves().live().points;
  ASSERT_TRUE(w.waitFor([&] { return points.size() == 1 && points.front().episode == 40; })) << "it was seen";
  w.session->looking().pin(std::vector<double>{0.1, 0.0, 0.0});
  const int undoable = w.session->history().undo().count();
  w.write(90);
  const std::string bytes = *readFile(w.path.toStdString());
  ASSERT_TRUE(w.shows(90));
  EXPECT_EQ(w.session->life().snapshot().steps, w.other->steps());
  ASSERT_TRUE(w.waitFor([&] { return points.size() == 2; }))
      << "a checkpoint has only its newest point: the curve is of the states that were seen";
  EXPECT_EQ(points.front().episode, 40);
  EXPECT_EQ(points.back().episode, 90);
  EXPECT_EQ(w.session->looking().pinnedState(), (std::vector<double>{0.1, 0.0, 0.0}));
  EXPECT_EQ(w.session->history().undo().count(), undoable) << "old states of the file are not kept";
  QTest::qWait(500);
  EXPECT_EQ(w.session->life().snapshot().steps, w.other->steps()) << "it learns nothing here";
  EXPECT_EQ(*readFile(w.path.toStdString()), bytes);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(w.folder.path().toStdString()), {}), 1);

  w.session->history().undo().undo();
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes == own; }));
  EXPECT_FALSE(w.window->follower().following());
  EXPECT_FALSE(w.session->looking().demonstrating());
}

TEST(LifeFollower, WhatGoesOnHereBecomesALifeOfOnesOwn) {
  FollowedLife w;
  w.write(20);
  w.window->follow(w.path);
  ASSERT_TRUE(w.shows(20));
  w.window->follower().goOn();
  EXPECT_TRUE(w.session->life().running());
  EXPECT_FALSE(w.window->follower().following());
  w.session->life().setTurbo(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().progress().episodes > 60; }));
  w.session->life().setRunning(false);
  EXPECT_TRUE(w.session->life().unsaved());
  EXPECT_TRUE(w.session->life().learned());
  w.write(30);
  QTest::qWait(2500);
  EXPECT_GT(w.session->life().progress().episodes, 60) << "the file is not looked at any more";

  w.window->follow(w.path);
  ASSERT_TRUE(w.shows(30));
  ASSERT_TRUE(w.session->life().setParameter("policy.temperature", 2.0));
  EXPECT_FALSE(w.window->follower().following()) << "a change is one's own, too";
  w.window->follow(w.path);
  ASSERT_TRUE(w.waitFor([&] { return w.says("as of"); }));
  w.session->looking().stepOnce();
  EXPECT_TRUE(w.waitFor([&] { return !w.window->follower().following(); }));
}

TEST(LifeFollower, ALifeThatIsOnlyLookedAtIsNotKeptForTheNextStart) {
  FollowedLife w;
  const QDir data(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
  const auto kept = [&] { return data.entryList({"*.surefoot"}, QDir::Files).size(); };
  const auto before = kept();
  w.write(20);
  w.window->follow(w.path);
  ASSERT_TRUE(w.shows(20));
  w.window->closeForNow();
  EXPECT_TRUE(w.waitFor([&] { return !w.window->isVisible(); }));
  EXPECT_EQ(kept(), before);
}

TEST(LifeFollower, BrokenFilesAndOtherKindsAreToldAndLookedAtAgain) {
  FollowedLife w;
  w.write(20);
  const std::string path = w.path.toStdString(), whole = *readFile(path);
  ASSERT_TRUE(writeWhole("file", path, whole.substr(0, whole.size() / 2)));
  w.session->life().setRunning(false);
  w.window->follower().follow(path);
  ASSERT_TRUE(w.waitFor([&] { return w.window->follower().following()->warns(); }));
  ASSERT_TRUE(writeWhole("file", path, qFileOf(*w.other, w.elsewhere).write()));
  ASSERT_TRUE(w.says("q-function")) << w.window->follower().text().toStdString();
  w.write(25);
  ASSERT_TRUE(w.shows(25));
  std::filesystem::remove(path);
  ASSERT_TRUE(w.says("It is gone"));
  EXPECT_EQ(w.session->life().numbers().episodes, 25);

  // Another life in the same file.
  w.elsewhere.seed = 8;
  w.other = std::move(*makeLife(w.registry, w.elsewhere, 0, false));
  w.other->keepInputs();
  w.write(12);
  ASSERT_TRUE(w.shows(12));
  EXPECT_EQ(w.session->life().configuration().seed, 8u);
  EXPECT_TRUE(w.window->follower().following());
}

}  // namespace surefoot
