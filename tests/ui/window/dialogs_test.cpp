// SPDX-License-Identifier: GPL-3.0-or-later
// Every dialog on the smallest screen and on a projector's: it fits, and no text is cut.
#include <QDialog>
#include <QDir>
#include <QPushButton>
#include <QScreen>
#include <QStandardPaths>
#include <QTreeWidget>
#include <functional>

#include "tests/ui/window/size_setup.h"
#include "ui/experiment/plans/plan_chooser.h"
#include "ui/live/live_page.h"

namespace surefoot {

namespace {

void trigger(Window& w, const char* menuItem) {
  for (QAction* action : w.window->findChildren<QAction*>())
    if (action->text() == QCoreApplication::translate("surefoot::MainWindow", menuItem)) action->trigger();
}

QDialog* dialogOf(Window& w) {
  QTest::qWait(30);
  for (auto* dialog : w.window->findChildren<QDialog*>())
    if (dialog->isVisible()) return dialog;
  return nullptr;
}

/// At both sizes of text, on the smallest screen and on a projector's.
void expectDialogReadable(Window& w, const std::function<void()>& open, const QString& name) {
  atEverySize({kScreens[3], kScreens[0], kScreens[2]}, [&](const Screen& screen, const QString& text) {
    applyTextSize(screen.text);
    open();
    QDialog* dialog = dialogOf(w);
    ASSERT_TRUE(dialog) << name.toStdString();
    const QSize room = dialog->screen()->availableGeometry().size();
    EXPECT_LE(dialog->width(), room.width()) << name.toStdString();
    EXPECT_LE(dialog->height(), room.height()) << name.toStdString();
    const QSize screenRoom = screen.size - QSize(16, 40);
    EXPECT_EQ(dialog->minimumSize().boundedTo(screenRoom), dialog->minimumSize()) << name.toStdString();
    dialog->resize(dialog->size().boundedTo(screenRoom));
    QTest::qWait(20);
    expectReadable(*dialog, name + ", " + text);
    for (const auto* button : dialog->findChildren<QPushButton*>()) {
      if (!button->isVisible() || button->parentWidget()->parentWidget()->inherits("QAbstractScrollArea")) continue;
      EXPECT_TRUE(dialog->rect().contains(QRect(button->mapTo(dialog, QPoint()), button->size())))
          << name.toStdString() << " " << button->text().toStdString();
    }
    dialog->close();
    QApplication::sendPostedEvents(dialog, QEvent::DeferredDelete);
  });
}

}  // namespace

TEST(Dialogs, PreLearningIsReadableInEveryTask) {
  const UsualLook usual;
  Window w;
  for (const EnvironmentEntry& entry : w.registry.environments) {
    const auto c = configure(w.registry, {.environment = entry.name}, {});
    ASSERT_TRUE(c) << c.error().message;
    ASSERT_TRUE(w.session->newLives().begin(*c)) << entry.name;
    const auto open = [&] {
      trigger(w, "&Pre-learn, then transfer …");
      const QDialog* dialog = dialogOf(w);
      ASSERT_TRUE(dialog) << entry.name;
      EXPECT_LE(dialog->height(), scaled(600)) << entry.name;
    };
    ASSERT_NO_FATAL_FAILURE(expectDialogReadable(w, open, "pre-learn " + QString::fromStdString(entry.name)));
  }
}

TEST(Dialogs, AllOthersAreReadable) {
  const UsualLook usual;
  const QDir data(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation));
  ASSERT_TRUE(data.mkpath("."));
  QFile report(data.filePath("last-crash.txt"));
  ASSERT_TRUE(report.open(QIODevice::WriteOnly));
  report.write("Surefoot was ended by SIGSEGV after 734 s.\n\nVersions\n  Surefoot 1\n  Qt 6.4.2\n");
  report.close();
  Window w;
  for (const char* name : {"Rob&ustness …", "&Shortcuts", "&About Surefoot", "Pre&ferences …", "Another &seed …",
                           "&Words", "&Keep this one as …", "Fil&m …", "&Report of the last crash"}) {
    const auto open = [&] { trigger(w, name); };
    ASSERT_NO_FATAL_FAILURE(expectDialogReadable(w, open, QString::fromUtf8(name).remove('&')));
  }
  report.remove();
  w.window->livePage().setComparing(true);
  const auto second = [&] {
    w.named<QPushButton>(QCoreApplication::translate("surefoot::CompareStrip", "Parameters of the second"))->click();
  };
  ASSERT_NO_FATAL_FAILURE(expectDialogReadable(w, second, "parameters of the second"));
}

TEST(Dialogs, TheListOfExperimentsIsReadable) {
  const UsualLook usual;
  PlanChooser box("Experiment", {{.title = "Quick", .path = "q.toml"},
                                 {.title = "After pre-learning on another pendulum",
                                  .path = "a.toml",
                                  .recipe = true,
                                  .group = "Chapter 4",
                                  .shows = {"4.4", "4.5", "4.6", "table 4.2"},
                                  .answers = "Which policy falls the least after pre-learning, and how much less than "
                                             "the one that is in common use?",
                                  .minutes = 40}});
  atEverySize({kScreens[0], kScreens[2]}, [&](const Screen& screen, const QString& text) {
    applyTextSize(screen.text);
    box.show();
    box.showPopup();
    QTest::qWait(20);
    auto* list = box.findChild<QTreeWidget*>();
    ASSERT_TRUE(list);
    list->setCurrentItem(list->topLevelItem(1)->child(0));
    expectReadable(*list->window(), "experiments, " + text);
    box.hidePopup();
  });
}

}  // namespace surefoot
