// SPDX-License-Identifier: GPL-3.0-or-later
#include <QComboBox>
#include <QLineEdit>
#include <QSpinBox>

#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/figure_panel.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"

namespace surefoot {

TEST(FocusHome, ReturnAndEscapeGiveTheKeysBackToThePage) {
  Window w;
  auto* number = w.named<QLineEdit>("Threshold, number");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "7");
  QTest::keyClick(number, Qt::Key_Return);
  ASSERT_TRUE(w.waitFor([&] { return !number->hasFocus(); }));
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), 7);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(w.session->life().configuration().parameters.get("policy.threshold"), 7) << "undo is the page's";
  const double before = w.session->life().configuration().parameters.get("policy.threshold");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "12");
  QTest::keyClick(number, Qt::Key_Escape);
  EXPECT_FALSE(number->hasFocus());
  EXPECT_EQ(w.session->life().configuration().parameters.get("policy.threshold"), before)
      << "what was typed is taken back";
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_TRUE(w.session->life().running());
}

TEST(FocusHome, AChoiceMadeByMouseLeavesTheKeysToThePage) {
  Window w;
  w.window->livePage().world().setFocus();
  auto* policy = w.named<QComboBox>("Policy");
  QTest::mouseClick(policy, Qt::LeftButton);
  policy->hidePopup();
  EXPECT_TRUE(w.window->livePage().world().hasFocus());
  policy->setFocus();
  QTest::keyClick(policy, Qt::Key_Escape);
  EXPECT_TRUE(w.window->livePage().world().hasFocus());
}

TEST(FocusHome, EscapeLeavesAFullSizePanelAndNoLayoutGivesTheFocusToAPageTab) {
  Window w;
  LivePage& live = w.window->livePage();
  Panel* maps = nullptr;
  for (Panel* panel : live.panels())
    if (panel->objectName() == "maps") maps = panel;
  Q_EMIT maps->header().fullSizeAsked();
  QTest::qWait(20);
  EXPECT_FALSE(live.world().isVisible());
  QTest::keyClick(w.window.get(), Qt::Key_Escape);
  QTest::qWait(20);
  EXPECT_TRUE(live.world().isVisible());
  for (const auto layout : {LivePage::Layout::Teaching, LivePage::Layout::Maps, LivePage::Layout::Usual}) {
    live.useLayout(layout);
    EXPECT_TRUE(live.world().hasFocus());
  }
}

TEST(FocusHome, TheExperimentPageLetsGoToo) {
  Window w;
  w.window->setPage(1);
  ExperimentPage& page = w.window->experimentPage();
  auto* lives = w.named<QSpinBox>("Lives a condition");
  for (const auto key : {Qt::Key_Return, Qt::Key_Escape}) {
    lives->setEnabled(true);
    lives->setFocus();
    ASSERT_TRUE(lives->hasFocus());
    QTest::keyClick(lives, key);
    EXPECT_TRUE(w.waitFor([&] { return page.hasFocus(); })) << key;
  }
  FigurePanel* figure = page.figures().front();
  Q_EMIT figure->header().fullSizeAsked();
  EXPECT_FALSE(page.figures().back()->isVisible());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_TRUE(page.figures().back()->isVisible());
}

}  // namespace surefoot
