// SPDX-License-Identifier: GPL-3.0-or-later
// Strips that scroll, and the controls in their header.
#include <QScrollBar>
#include <QToolButton>

#include "tests/ui/live/signalling.h"
#include "tests/ui/pixels_of.h"
#include "ui/controls/panel.h"
#include "ui/live/signals/scrolled_strips.h"
#include "ui/live/signals/strip_painter.h"
#include "ui/style/theme.h"

namespace surefoot {

TEST(Strips, TheTimeAxisStaysInSightWhereTheyScroll) {
  Signalling w;
  w.learn(20);
  w.bar->rollOut();
  w.shown->seek(10.0);
  std::vector<Strip> many;
  for (const Signal& signal : w.shown->table().signals())
    if (signal.group != "time") many.push_back({signal.key});
  for (int i = 0; i < 2; ++i) many.insert(many.end(), many.begin(), many.end());
  w.shown->setStrips(many);
  auto* area = w.window->findChild<ScrolledStrips*>();
  ASSERT_TRUE(w.waitFor([&] { return area->verticalScrollBar()->maximum() > 100; }));
  const auto lowest = [&](int scrolled) {
    area->verticalScrollBar()->setValue(scrolled);
    QTest::qWait(50);
    const QImage picture = area->viewport()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    constexpr int kTimes = static_cast<int>(StripPainter::kTimes);
    return picture.copy(0, picture.height() - kTimes, picture.width(), kTimes);
  };
  const QImage top = lowest(0);
  EXPECT_GT(pixelsOf(top, themeOf(*w.charts).ink), 200) << "the moment";
  EXPECT_EQ(top, lowest(60));
  EXPECT_EQ(top, lowest(area->verticalScrollBar()->maximum()));
  for (QWidget* over : area->viewport()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (over != w.charts) over->hide();
  EXPECT_EQ(top, lowest(area->verticalScrollBar()->maximum())) << "it is the charts' own";
  EXPECT_NE(top, lowest(0));
  w.shown->setUsualStrips();
}

/// The controls of a header that Tab reaches from its first one on, until it leaves the header.
QList<QWidget*> tabbedThrough(QWidget* header, QWidget* first) {
  QList<QWidget*> reached;
  first->setFocus(Qt::TabFocusReason);
  while (header->isAncestorOf(QApplication::focusWidget()) && reached.size() < 20) {
    reached << QApplication::focusWidget();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  return reached;
}

TEST(Strips, TabGoesThroughTheHeaderFromLeftToRight) {
  Signalling w;
  w.window->resize(1900, 1000);
  QTest::qWait(100);
  QWidget* header = w.bar->parentWidget();
  QList<QWidget*> seen;
  for (auto* button : header->findChildren<QAbstractButton*>())
    if (button->isVisible()) seen << button;
  const auto x = [&](QWidget* widget) { return widget->mapTo(header, QPoint()).x(); };
  std::sort(seen.begin(), seen.end(), [&](QWidget* a, QWidget* b) { return x(a) < x(b); });
  ASSERT_GE(seen.size(), 6) << "five words and full size";
  EXPECT_EQ(tabbedThrough(header, seen.front()), seen);
  EXPECT_TRUE(w.charts->hasFocus()) << "the strips come after their header, and not "
                                    << QApplication::focusWidget()->accessibleName().toStdString();
}

}  // namespace surefoot
