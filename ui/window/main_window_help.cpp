// SPDX-License-Identifier: GPL-3.0-or-later
// The menu Help, and the handbook with the ways that lead to its pages.
#include <QApplication>
#include <QMenuBar>
#include <QStackedWidget>
#include <QWhatsThisClickedEvent>

#include "ui/controls/message_bar.h"
#include "ui/experiment/experiment_page.h"
#include "ui/handbook/handbook_window.h"
#include "ui/lessons/lessons_page.h"
#include "ui/robot/robot_page.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/help.h"
#include "ui/window/main_window.h"

namespace surefoot {

void MainWindow::makeHelpMenu() {
  setHelpPage(*this, QStringLiteral("window"));
  setHelpPage(*experiment_, QStringLiteral("page-experiment"));
  setHelpPage(*lessons_, QStringLiteral("page-lessons"));
  setHelpPage(*robot_, QStringLiteral("page-robot"));
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  const auto item = [&](const QString& text, const QString& tip, const QKeySequence& key, auto slot) {
    connect(addAction(help, text, tip, key), &QAction::triggered, this, slot);
  };
  item(tr("&Handbook"), tr("The handbook, at the page of what has the focus"), Qt::Key_F1, [this] {
    const bool lesson = pages_->currentWidget() == lessons_ && lessons_->view();
    lesson ? lessons_->showHint() : showHandbook();
  });
  item(tr("&Shortcuts"), tr("All shortcuts"), QKeySequence(Qt::CTRL | Qt::Key_F1), &MainWindow::showShortcuts);
  item(tr("&Words"), tr("What the words mean, with their formulas"), {}, [this] { showWords({}); });
  item(tr("Write a &lesson"), tr("A lesson of one's own as text, from a template"), {}, [this] {
    setPage(kLessonsPage);
    lessons_->editTemplate();
  });
  item(tr("&Report of the last crash"), tr("What Surefoot noted when it crashed, to be sent by hand"), {},
       &MainWindow::showReport);
  item(tr("&About Surefoot"), tr("What this is"), {}, &MainWindow::showAbout);
}

void MainWindow::showHandbook(const QString& page) {
  if (!handbook_) {
    const auto handbook = makeHandbook_
                              ? makeHandbook_()
                              : Result<Handbook>(Error{QObject::tr("The handbook is not there.").toStdString()});
    if (!handbook) return messages_->say(toText(handbook.error().message));
    handbook_ = new HandbookWindow(*handbook, pictures_, this);
    connect(handbook_, &HandbookWindow::textSizeAsked, this,
            [this](int steps) { setTextSize(steps == 0 ? 1.0 : textSize() + steps * kTextStep); });
  }
  const QWidget* focus = QApplication::focusWidget();
  const bool here = focus && focus->window() == this;  // a menu or the handbook has it, else
  handbook_->open(!page.isEmpty() ? page : helpPageOf(here ? focus : pages_->currentWidget()));
}

HandbookWindow* MainWindow::handbook() const {
  return handbook_;
}

// A "?" was pressed somewhere in the window.
bool MainWindow::event(QEvent* event) {
  if (event->type() != QEvent::WhatsThisClicked) return QMainWindow::event(event);
  showHandbook(static_cast<QWhatsThisClickedEvent*>(event)->href());
  event->accept();
  return true;
}

}  // namespace surefoot
