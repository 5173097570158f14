// SPDX-License-Identifier: GPL-3.0-or-later
// The few small dialogs of the window.
#include <QGridLayout>
#include <QInputDialog>
#include <QLabel>

#include "core/text/number_text.h"
#include "ui/about/about_dialog.h"
#include "ui/controls/fitted_dialog.h"
#include "ui/controls/message_bar.h"
#include "ui/crash/crash_dialog.h"
#include "ui/crash/crash_reports.h"
#include "ui/live/form/pre_learning_dialog.h"
#include "ui/robustness/robustness_dialog.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/window/film_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/words_dialog.h"

namespace surefoot {

void MainWindow::askForSeed() {
  auto* dialog = new QInputDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Another seed"));
  dialog->setLabelText(tr("The life begins again with this seed, a whole number from 0 on:"));
  dialog->setTextValue(QString::number(session_.life().configuration().seed));
  connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& text) {
    const auto seed = parseSeed("seed", text.trimmed().toStdString());
    if (!seed) return messages_->say(toText(seed.error().message));
    begin([this, seed = *seed] { return session_.newLives().setSeed(seed); });
  });
  dialog->open();
}

void MainWindow::showPreLearning() {
  for (const auto& [environment, dialog] : preLearning_)
    if (dialog) dialog->hide();
  auto& dialog = preLearning_[session_.life().configuration().names.environment];
  if (!dialog) {
    dialog = new PreLearningDialog(session_.life(), session_.newLives(), this);
    connect(dialog, &PreLearningDialog::transferred, messages_, &MessageBar::tell);
  }
  dialog->show();
  dialog->raise();
}

void MainWindow::showRobustness() {
  if (robustness_ && robustness_->environment() != session_.life().configuration().names.environment)
    robustness_->close();  // it asks of another robot
  if (!robustness_ || !robustness_->isVisible()) {
    robustness_ = new RobustnessDialog(session_.life(), session_.files(), this);
    robustness_->setSecond(session_.looking().secondPath());  // chosen once, it is the second everywhere
    connect(robustness_, &RobustnessDialog::secondChosen, live_, &LivePage::setSecond);
  }
  robustness_->show();
  robustness_->raise();
  robustness_->activateWindow();
}

void MainWindow::showFilm() {
  if (film_ && film_->busy()) return film_->raise(), film_->activateWindow();
  delete film_;
  film_ = new FilmDialog(session_.life(), session_.looking(), this);
  connect(film_, &FilmDialog::made, messages_, &MessageBar::tell);
  film_->show();
}

void MainWindow::showShortcuts() {
  auto* dialog = new QDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Shortcuts"));
  auto* body = new QWidget;
  auto* grid = new QGridLayout(body);
  whenScaled(dialog, [grid] {
    grid->setContentsMargins(scaled({24, 20, 24, 20}));
    grid->setHorizontalSpacing(scaled(32));
  });
  int row = 0;
  for (const QAction* action : shortcuts_) {
    QStringList keys;
    for (const QKeySequence& key : action->shortcuts()) keys << key.toString(QKeySequence::NativeText);
    auto* label = new QLabel(keys.join(tr(" or ")));
    whenScaled(label, [label] { label->setFont(scaledFont(13, 500)); });
    grid->addWidget(label, row, 0);
    grid->addWidget(new QLabel(action->toolTip()), row++, 1);
  }
  fillDialog(*dialog, body);
  dialog->show();
}

void MainWindow::showWords(const std::string& name) {
  if (!words_) words_ = new WordsDialog(this);
  words_->showWord(name);
  words_->show();
  words_->raise();
  words_->activateWindow();
}

void MainWindow::offerReport() {
  if (!takeNewCrash(folder_)) return;
  messages_->ask(tr("Surefoot crashed. A report of it is on this computer; nothing was sent."),
                 {{tr("Show the report"), [this] { showReport(); }}, {tr("Leave it there"), {}}},
                 MessageBar::Question::Report);
}

void MainWindow::showReport() {
  const QString report = lastCrash(folder_);
  if (report.isEmpty()) return messages_->tell(tr("There is no report of a crash."));
  (new CrashDialog(report, this))->show();
}

void MainWindow::showAbout() {
  auto* dialog = new AboutDialog(about_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->show();
}

}  // namespace surefoot
