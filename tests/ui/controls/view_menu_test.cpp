// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controls/view_menu.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>

#include "tests/ui/window_setup.h"
#include "ui/controls/panel.h"
#include "ui/experiment/figures/figure_view.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/support/exporting.h"

namespace surefoot {

namespace {

/// What the menu that is open offers; closes it.
QStringList offered() {
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  if (!menu) return {};
  QStringList texts;
  for (const QAction* action : menu->actions()) texts << action->text();
  menu->close();
  return texts;
}

}  // namespace

TEST(ViewMenu, EveryViewHasOneByMouseAndByKeys) {
  Window w;
  std::vector<QWidget*> views{&w.window->livePage().world()};
  for (Panel* panel : w.window->livePage().panels())
    if (panel->objectName() != "parameters") views.push_back(panel->view());
  for (FigureView* figure : w.window->findChildren<FigureView*>()) views.push_back(figure);
  ASSERT_GE(views.size(), 9u);
  for (QWidget* view : views) {
    SCOPED_TRACE(view->accessibleName().toStdString() + " " + view->metaObject()->className());
    EXPECT_NE(view->focusPolicy(), Qt::NoFocus);
    QContextMenuEvent byMouse(QContextMenuEvent::Mouse, view->rect().center(), view->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(view, &byMouse);
    const QStringList texts = offered();
    EXPECT_TRUE(texts.contains("Copy the picture"));
    for (const char* format : {"PNG", "SVG", "PDF"}) EXPECT_TRUE(texts.contains(QString("Export as %1 …").arg(format)));
    EXPECT_TRUE(!dynamic_cast<CsvSource*>(view) || texts.contains("Export as CSV …"));
    QTest::keyClick(view, Qt::Key_Menu);
    EXPECT_FALSE(offered().isEmpty()) << "by the Menu key";
    QTest::keyClick(view, Qt::Key_F10, Qt::ShiftModifier);
    EXPECT_FALSE(offered().isEmpty()) << "by Shift+F10";
  }
}

TEST(ViewMenu, CopiesThePictureAndTheNumbers) {
  Window w;
  w.session->life().setTurbo(true);
  w.session->life().setRunning(true);
  ASSERT_TRUE(w.waitFor([&] { return w.session->life().numbers().falls > 5; }));
  w.session->life().setRunning(false);
  QTest::qWait(150);
  auto* falls = w.window->livePage().findChild<Panel*>("falls")->widget();
  QTest::keyClick(falls, Qt::Key_Menu);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  ASSERT_TRUE(menu);
  for (QAction* action : menu->actions())
    if (action->text().startsWith("Copy")) action->trigger();
  menu->close();
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("life,policy,minutes,falls\n"));
}

}  // namespace surefoot
