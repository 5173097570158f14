// SPDX-License-Identifier: GPL-3.0-or-later
// The window on small screens and from the last row: its size and its text size.
#include <QScreen>
#include <cmath>

#include "tests/ui/window/size_setup.h"
#include "ui/controls/message_bar.h"
#include "ui/controls/panel.h"
#include "ui/controls/preferences.h"
#include "ui/live/live_page.h"

namespace surefoot {

TEST(TextSize, EveryTextFollowsIt) {
  const UsualSize usual;
  Window w;
  const int before = w.window->livePage().panels().front()->header().QWidget::height();
  applyTextSize(kProjectorText);
  QTest::qWait(50);
  for (const QWidget* widget : w.window->findChildren<QWidget*>())
    EXPECT_GE(widget->font().pixelSize(), scaled(11) - 1) << nameOf(*widget).toStdString();
  EXPECT_EQ(w.window->livePage().panels().front()->header().QWidget::height(), scaled(before));
  applyTextSize(1.0);
  QTest::qWait(50);
  EXPECT_EQ(w.window->livePage().panels().front()->header().QWidget::height(), before);
}

TEST(TextSize, KeysChangeItAndItIsKept) {
  const UsualSize usual;
  Window w;
  QTest::keyClick(w.window.get(), Qt::Key_Plus, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(textSize(), 1.1);
  EXPECT_NEAR(readPreferences().textSize, 1.1, 1e-9);
  QTest::keyClick(w.window.get(), Qt::Key_Minus, Qt::ControlModifier);
  QTest::keyClick(w.window.get(), Qt::Key_Minus, Qt::ControlModifier);
  EXPECT_NEAR(textSize(), 0.9, 1e-9);
  QTest::keyClick(w.window.get(), Qt::Key_0, Qt::ControlModifier);
  EXPECT_DOUBLE_EQ(textSize(), 1.0);
  applyTextSize(17);
  EXPECT_DOUBLE_EQ(textSize(), kLargestText);
  applyTextSize(std::nan(""));
  EXPECT_DOUBLE_EQ(textSize(), kLargestText) << "not a number is no size";
}

TEST(WindowSize, FitsTheScreenAtTheFirstStartAndWhenRestored) {
  const UsualSize usual;
  Window w;
  const QSize screen = w.window->screen()->availableGeometry().size();
  EXPECT_LE(w.window->minimumSizeHint().expandedTo(w.window->minimumSize()).width(), 1024);
  EXPECT_LE(w.window->minimumSizeHint().expandedTo(w.window->minimumSize()).height(), 640);
  w.window->resize(4000, 3000);
  QSettings().setValue("geometry", w.window->saveGeometry());
  MainWindow again(*w.session);
  EXPECT_LE(again.width(), screen.width());
  EXPECT_LE(again.height(), screen.height());
  applyTextSize(kLargestText);
  EXPECT_LE(again.minimumSizeHint().expandedTo(again.minimumSize()).width(), 1024);
}

TEST(WindowSize, AMessageHasARowOfItsOwnAndCoversNothing) {
  Window w;
  for (int page = 0; page < 4; ++page) {
    w.window->setPage(page);
    w.window->messages().say("Something that could not be done, and what is allowed.");
    QTest::qWait(50);
    EXPECT_TRUE(w.window->messages().isVisible());
    const QWidget* parent = w.window->messages().parentWidget();
    for (const QWidget* other : parent->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
      if (other == &w.window->messages() || !other->isVisible()) continue;
      EXPECT_FALSE(other->geometry().intersects(w.window->messages().geometry())) << nameOf(*other).toStdString();
    }
    w.window->messages().dismiss();
  }
}

}  // namespace surefoot
