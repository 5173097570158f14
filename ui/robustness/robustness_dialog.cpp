// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robustness/robustness_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/files/tensor_file.h"
#include "core/files/whole_file.h"
#include "ui/controls/fitted_dialog.h"
#include "ui/controls/labels.h"
#include "ui/language/numbers.h"
#include "ui/robustness/robustness_form.h"
#include "ui/robustness/robustness_map.h"
#include "ui/running/running_life.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/announce.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/exporting.h"

namespace surefoot {

namespace {

constexpr const char* kUnsavedName = "learned.safetensors";

QPushButton* makeButton(const QString& text) {
  auto* button = new QPushButton(text);
  button->setAutoDefault(false);
  return button;
}

}  // namespace

RobustnessDialog::RobustnessDialog(RunningLife& life, LifeFiles& files, QWidget* parent)
    : QDialog(parent),
      life_(life),
      environment_(life.configuration().names.environment),
      run_(life, files),
      form_(new RobustnessForm(life)),
      map_(new RobustnessMap) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Robustness"));
  QWidget* body = makeBody();
  fillDialog(*this, body, makeFoot());
  connect(&run_, &RobustnessRun::changed, this, &RobustnessDialog::refresh);
  connect(&run_, &RobustnessRun::refused, this, &RobustnessDialog::say);
  connect(&run_, &RobustnessRun::finished, this, [this] {
    saved_.clear();
    map_->show(run_.result());
    say(toText(run_.result()->plan.note));
    announce(*map_, tr("The map is there: %1 models, %2 pushes. The arrow keys choose a cell.")
                        .arg(run_.result()->plan.models.size())
                        .arg(run_.result()->plan.pushes.size()));
  });
  connect(map_, &RobustnessMap::chosen, this, [this] {
    said_.clear();
    refreshWords();
  });
  connect(form_, &RobustnessForm::edited, this, &RobustnessDialog::refreshCommand);
  connect(form_, &RobustnessForm::secondChosen, this, &RobustnessDialog::secondChosen);
  refresh();
}

void RobustnessDialog::setSecond(const QString& path) {
  form_->setSecond(path);
}

QWidget* RobustnessDialog::makeBody() {
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(form_);
  column->addWidget(map_, 1);
  auto* row = new QHBoxLayout;
  command_ = makeText({}, 11, 400, true, body);
  command_->setWordWrap(true);
  command_->setTextFormat(Qt::PlainText);
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  command_->setAccessibleName(tr("The command that gives the same numbers"));
  copy_ = makeButton(tr("Copy the command"));
  row->addWidget(command_, 1);
  row->addWidget(copy_, 0, Qt::AlignBottom);
  column->addLayout(row);
  whenScaled(this, [column, row] {
    column->setContentsMargins(scaled({24, 16, 24, 8}));
    column->setSpacing(scaled(12));
    row->setSpacing(scaled(12));
  });
  connect(copy_, &QPushButton::clicked, this, [this] {
    QApplication::clipboard()->setText(command_->property("command").toString());
    say(tr("The command is copied."));
  });
  return body;
}

QWidget* RobustnessDialog::makeFoot() {
  auto* foot = new QWidget;
  auto* column = new QVBoxLayout(foot);
  words_ = new QLabel;
  words_->setWordWrap(true);
  words_->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout;
  save_ = makeButton(tr("Save what was tried …"));
  export_ = makeButton(tr("Export the map …"));
  try_ = makeButton(tr("Try"));
  try_->setDefault(true);  // Return in a field tries
  row->addStretch(1);
  for (QPushButton* button : {save_, export_, try_}) row->addWidget(button);
  column->addWidget(words_);
  column->addLayout(row);
  whenScaled(this, [this, column, row] {
    words_->setMinimumHeight(scaled(44));  // two lines, also of a font with high signs: it stays where it is
    column->setContentsMargins(scaled({24, 4, 24, 16}));
    column->setSpacing(scaled(8));
    row->setSpacing(scaled(8));
  });
  connect(try_, &QPushButton::clicked, this, &RobustnessDialog::tryOrStop);
  connect(save_, &QPushButton::clicked, this, &RobustnessDialog::saveTried);
  connect(export_, &QPushButton::clicked, this, &RobustnessDialog::exportMap);
  return foot;
}

void RobustnessDialog::tryOrStop() {
  if (run_.busy()) {
    run_.cancel();
    return say(tr("Stopped; nothing came out."));
  }
  if (life_.configuration().names.environment != environment_)
    return say(tr("Another environment is learned in now; close this window and open it again."));
  said_.clear();
  run_.start(form_->question(), form_->second());
}

void RobustnessDialog::saveTried() {
  askForNewFile(this, tr("Save the Q-function that was tried"), kUnsavedName, QStringLiteral("*.safetensors"),
                QStringLiteral("safetensors"), [this, tried = run_.tried()](const QString& path) {
                  const Status s = writeWhole("file", path.toStdString(), tried->write());
                  if (!s) return say(toText(s.error().message));
                  if (tried == run_.tried()) saved_ = path.toStdString();
                  say(tr("%1 is written.").arg(path));
                  refreshCommand();
                });
}

void RobustnessDialog::exportMap() {
  askForNewFile(this, tr("Export the map"), QStringLiteral("robustness.png"),
                tr("Picture (*.png);;Vector graphics (*.svg);;Document (*.pdf);;Table (*.csv)"), QStringLiteral("png"),
                [this](const QString& path) {
                  const Status s = exportView(*map_, path.toStdString());
                  say(s ? tr("%1 is written.").arg(path) : toText(s.error().message));
                });
}

void RobustnessDialog::say(const QString& sentence) {
  said_ = sentence;
  refresh();
  if (!sentence.isEmpty()) announce(*words_, sentence);
}

void RobustnessDialog::refresh() {
  const bool busy = run_.busy();
  try_->setText(busy ? tr("Stop") : tr("Try"));
  save_->setEnabled(run_.tried() && !busy);
  export_->setEnabled(run_.result() && !busy);
  refreshWords();
  refreshCommand();
}

// Of the work, of what was done, of the chosen cell, or what can be done.
void RobustnessDialog::refreshWords() {
  const QStringList cell = map_->spoken();
  words_->setText(run_.busy() ? tr("%1 % is done. The life goes on meanwhile.").arg(fixedNumber(100 * run_.share(), 0))
                  : !said_.isEmpty() ? said_
                  : !cell.isEmpty()  ? cell.join('\n')
                  : run_.result()
                      ? tr("The mouse or the arrow keys choose a cell.")
                      : tr("Every cell is tried from the same starts: it lives, is pushed once, and is followed."));
}

// What is in the fields, so that it can be asked elsewhere without being tried here; of what was tried, once it is
// saved.
void RobustnessDialog::refreshCommand() {
  std::vector<std::string> files = {saved_.empty() ? kUnsavedName : saved_};
  if (!form_->second().empty()) files.push_back(form_->second());
  const QString command = toText(robustnessCommandLine(form_->question(), files));
  command_->setProperty("command", command);
  command_->setText((saved_.empty() ? tr("Without a window, once what was tried is saved as %1:\n").arg(kUnsavedName)
                                    : tr("Without a window:\n")) +
                    command);
}

}  // namespace surefoot

#include "moc_robustness_dialog.cpp"
