// SPDX-License-Identifier: GPL-3.0-or-later
// The risk of a fall in the window: rows, maps, form, status.
#include <QImage>
#include <QTemporaryDir>
#include <atomic>
#include <filesystem>

#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"
#include "tests/ui/pixels_of.h"
#include "tests/ui/window_setup.h"
#include "ui/live/actions/action_rows.h"
#include "ui/live/form/parameter_row.h"
#include "ui/live/maps/value_maps.h"
#include "ui/session/q_pool.h"
#include "ui/style/theme.h"
#include "ui/window/status_line.h"

namespace surefoot {

namespace {

/// A window whose learner has learned risk for a while, boldly, is paused and obeys a rule from now on.
struct Cautious : Window {
  explicit Cautious(const std::string& rule) : Window("softmax", std::nullopt, {{"risk.learn", "on"}}) {
    session->life().setTurbo(true);
    session->life().setRunning(true);
    EXPECT_TRUE(waitFor([&] { return session->life().snapshot().totals.episodes > 300 && session->life().values(); }));
    session->life().setRunning(false);
    const Parameter& caution = session->life().configuration().parameters.find("policy.risk")->parameter;
    EXPECT_TRUE(session->editing().setParameter("policy.risk", *parseValue(caution, rule)));
    QTest::qWait(250);
  }
  /// The rows in a state.
  ActionRows* rowsIn(const std::vector<double>& state) {
    session->looking().examine(state);
    QTest::qWait(300);
    return window->findChild<ActionRows*>();
  }
};

const std::vector<double> kFalling = {1.0, 8.0, 0.0};  // nothing helps any more

}  // namespace

TEST(RiskViews, ARowHasTheRiskOfItsAction) {
  Cautious w("filter");
  const std::string csv = w.rowsIn(kFalling)->asCsv();
  EXPECT_TRUE(csv.starts_with("action,q,risk,epsilon-greedy,")) << csv.substr(0, 60);
  const auto line = csv.find('\n') + 1;
  const auto fields = csv.substr(line, csv.find('\n', line) - line);
  EXPECT_GT(std::stod(fields.substr(fields.find(',', fields.find(',') + 1) + 1)), 0.1) << fields;
}

TEST(RiskViews, TheRowsSayWhatCautionLeavesOut) {
  Cautious filter("filter");
  EXPECT_EQ(filter.rowsIn(kFalling)->sentence(), "All are above the limit: the least risky is taken.");
  EXPECT_GT(pixelsOf(filter.rowsIn(kFalling)->grab().toImage(), lightTheme().fall), 200) << "bars";
  Cautious off("off");
  EXPECT_EQ(off.rowsIn(kFalling)->sentence(), "");
  Cautious weight("weight");
  EXPECT_TRUE(weight.rowsIn(kFalling)->sentence().contains("is worth most, but its risk of"));
}

TEST(RiskViews, TheLimitIsALineToDrag) {
  Cautious w("filter");
  auto* rows = w.rowsIn(kFalling);
  const QImage image = rows->grab().toImage();
  int x = -1;  // the dashed line below the flag
  for (int column = image.width() / 4; column < image.width() * 2 / 3 && x < 0; ++column)
    for (int y = 30; y < 60; ++y)
      if (image.pixelColor(column, y) == lightTheme().trl) x = column;
  ASSERT_GE(x, 0);
  QTest::mousePress(rows, Qt::LeftButton, {}, {x, 100});
  QTest::mouseMove(rows, {x + 20, 100});
  QTest::mouseRelease(rows, Qt::LeftButton, {}, {x + 20, 100});
  const double limit = w.session->life().configuration().parameters.get("policy.risk_limit");
  EXPECT_GT(limit, 0.05);
  EXPECT_LT(limit, 0.5);
}

TEST(RiskViews, MapsOfRiskAreOfferedAndDrawn) {
  Cautious w("filter");
  auto* maps = w.window->findChild<ValueMaps*>();
  MapChoice choice = maps->choice();
  choice.quantity = MapQuantity::Risk;
  maps->setChoice(choice);
  EXPECT_EQ(maps->choice().quantity, MapQuantity::Risk);
  const std::string csv = maps->asCsv();
  EXPECT_NE(csv.find("risk of a fall"), std::string::npos);
  w.session->looking().examine(kFalling);
  QTest::qWait(100);
  EXPECT_TRUE(maps->spoken().contains("risk ")) << maps->spoken().toStdString();
}

TEST(RiskViews, TheFormShowsTheSettingsOfTheRuleInForce) {
  Cautious w("filter");
  const auto shown = [&](const char* key) {
    for (const ParameterRow* row : w.window->findChildren<ParameterRow*>())
      if (row->key() == key) return !row->isHidden();
    return false;
  };
  EXPECT_TRUE(shown("risk.learn") && shown("policy.risk") && shown("policy.risk_limit") && shown("risk.scale"));
  EXPECT_FALSE(shown("policy.risk_weight") || shown("policy.losses_factor"));
  ASSERT_TRUE(w.session->editing().setParameter("policy.risk", 1));
  QTest::qWait(50);
  EXPECT_TRUE(shown("policy.risk_weight"));
  EXPECT_FALSE(shown("policy.risk_limit"));
}

TEST(RiskViews, AGuardianThatIsNotThereIsRefused) {
  Cautious w("off");
  const auto refused = w.session->editing().setParameter("policy.guardian", 1.0);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("no hand-made controller"), std::string::npos) << refused.error().message;
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.guardian"), 0.0);
}

TEST(RiskViews, AQFunctionOfAFileIsTheGuardianFromNowOn) {
  Cautious w("off");
  QTemporaryDir folder;
  const std::string path = folder.filePath("teacher.safetensors").toStdString();
  TensorFile learned;
  std::atomic<bool> written = false;
  const Configuration now = w.session->life().configuration();
  w.session->life().visit([&](const Life& life) {
    learned = qFileOf(life, now);
    written = true;
  });
  ASSERT_TRUE(w.waitFor([&] { return written.load(); }));
  ASSERT_TRUE(writeWhole("q", path, learned.write()));
  ASSERT_TRUE(w.session->editing().guardBy(path));
  ASSERT_TRUE(w.session->editing().setParameter("policy.guardian_limit", 0.0));
  w.session->life().setRunning(true);
  EXPECT_TRUE(w.waitFor([&] { return w.session->life().values()->guarded > 100; }));
  EXPECT_FALSE(w.session->editing().guardBy(folder.filePath("none.safetensors").toStdString()));

  // The session that is saved now has it, and opens where the file is not.
  w.session->life().setRunning(false);
  const std::string saved = folder.filePath("guarded.surefoot").toStdString();
  std::optional<Status> status;
  w.session->files().save(SavedAs::Session, saved, [&](const Status& s) { status = s; });
  ASSERT_TRUE(w.waitFor([&] { return status.has_value(); }));
  ASSERT_TRUE(*status) << status->error().message;
  std::filesystem::remove(path);
  const auto file = readQFile(saved);
  ASSERT_TRUE(file) << file.error().message;
  const auto resumed = resume(w.session->life().registry(), *file, {});
  ASSERT_TRUE(resumed) << resumed.error().message;
  EXPECT_TRUE(resumed->configuration.teacher);
}

// What a robot is careful by in reality it learns boldly.
TEST(RiskViews, APreLearningIsBold) {
  Window w;
  QPool pool(w.registry);
  Configuration simulation = pendulumConfiguration(
      w.registry, "softmax", {{"risk.learn", "on"}, {"policy.risk", "filter"}, {"policy.risk_limit", "0.001"}});
  simulation.episodes = 5;
  pool.start(simulation, 1);
  ASSERT_TRUE(w.waitFor([&] { return pool.pool().size() == 1; }));
  const Json& about = pool.pool()[0].file->about;
  EXPECT_FALSE(about["configuration"]["parameters"].contains("policy.risk")) << "off, as usual";
  EXPECT_TRUE(about["estimates"].contains("risk"));
}

TEST(RiskViews, TheStatusComparesWhatWasSaidWithWhatCame) {
  Cautious w("off");
  const QString all = w.window->findChild<StatusLine*>()->texts().join('|');
  EXPECT_TRUE(all.contains(" % said, ") && all.contains(" % fell")) << all.toStdString();
  Window without;
  EXPECT_FALSE(without.window->findChild<StatusLine*>()->texts().join('|').contains("said"));
}

}  // namespace surefoot
