// SPDX-License-Identifier: GPL-3.0-or-later
// Files on the Robot page: open, begin like another, save.
#include <QFileInfo>
#include <QMenu>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "core/environment_programs.h"
#include "core/files/read_file.h"
#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/text_button.h"
#include "ui/language/numbers.h"
#include "ui/robot/random_life.h"
#include "ui/robot/robot_checked.h"
#include "ui/robot/robot_picture.h"
#include "ui/robot/robot_text.h"
#include "ui/robot/state_table.h"
#include "ui/style/symbol_text.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/plain_text.h"

namespace surefoot {

void RobotPage::fillFiles() {
  files_->clear();
  connect(files_->addAction(tr("Open…")), &QAction::triggered, this, &RobotPage::openWithDialog);
  connect(files_->addAction(tr("Save as…")), &QAction::triggered, this, &RobotPage::saveAs);
  files_->addSeparator();
  files_->addSection(tr("A new robot, like"));
  if (!registry_.files) return;
  for (const std::string& name : registry_.files->shelved())
    connect(files_->addAction(toText(name)), &QAction::triggered, this, [this, name] { beginLike(toText(name)); });
}

void RobotPage::offer(const EnvironmentFile& robot) {
  if (chosen_ || isEdited() || robot.entry.name == std::exchange(offered_, robot.entry.name)) return;
  if (!everShown_ && source_.draft()) return;
  const QFileInfo file(toText(robot.path));
  if (robot.path.empty() || !file.exists())
    beginWith(toText(robot.text));  // it came inside another file
  else if (file.canonicalPath() == QFileInfo(toText(registry_.files->shelf())).canonicalFilePath())
    beginLike(file.completeBaseName());  // what comes with the program is not written to
  else
    open(file.absoluteFilePath());
  chosen_ = false;
}

void RobotPage::openWithDialog() {
  askForFile(this, tr("Open a robot"), tr("Robots (*.toml)"), [this](const QString& path) { open(path); });
}

void RobotPage::open(const QString& path) {
  everShown_ = chosen_ = true;
  setAside();
  const auto text = source_.open(QFileInfo(path).absoluteFilePath());
  if (!text) return Q_EMIT refused(toText(text.error().message));
  begin(*text);
}

/// Another robot: nothing of the one before is shown any more.
void RobotPage::begin(const QString& text) {
  trial_.stop();
  checked_.reset();
  showInspection(nullptr);
  text_->replaceAll(text);
  text_->moveCursor(QTextCursor::Start);
  check();
}

void RobotPage::showInspection(const EnvironmentInspection* inspection) {
  picture_->setInspection(inspection);
  table_->setInspection(inspection);
  life_->setInspection(inspection);
}

/// A robot is data, or it starts a program, which has to be allowed; that one can be watched on the Live page only.
void RobotPage::refreshProgram() {
  const EnvironmentFile* file = checked_ ? &*checked_->file : nullptr;
  const bool starts = file && !file->starts.empty();
  textHead_->setNote(starts ? tr("starts %1").arg(toText(file->starts))
                            : tr("TOML, checked while you type; runs nothing"));
  allow_->setVisible(starts && !registry_.programs->isAllowed(file->program));
  for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{try_, random_, still_, passive_, drop_})
    button->setEnabled(file && !starts);
  passive_->setVisible(file && file->passive);
  drop_->setVisible(file && file->dropped);
  try_->setToolTip(starts ? tipText(tr("A program moves it: let it learn, and it moves on the Live page."))
                          : QString());
}

void RobotPage::allow() {
  registry_.programs->allow(checked_->file->program);
  check();
  refresh();
}

void RobotPage::explain() {
  if (!help_) {
    const auto text =
        registry_.files ? readText(registry_.files->shelf() + "/format.md") : Result<std::string>(Error{});
    help_ = std::make_shared<RobotHelp>(text ? toText(*text) : QString());
  }
  const RobotTextPlace place = text_->caret();
  const QString help = help_->of(place.section, place.key), value = valueAtCaret();
  text_->explain(
      QStringList{help.isEmpty() ? tr("Nothing is known of this word.") : help, value}.join(u'\n').trimmed());
}

/// "= 0.31 at the start of an episode": of the expressions in the caret's line, as the text stands.
QString RobotPage::valueAtCaret() const {
  if (!checked_ || wrong_ || text_->toPlainText() != checked_->text) return {};
  const int line = text_->textCursor().blockNumber() + 1;
  QStringList values;
  for (const FormulaValue& formula : checked_->inspection.formulas)
    if (formula.at.line == line) values << localNumbers(QString::number(formula.value, 'g', 4));
  if (values.isEmpty()) return {};
  return tr("line %1 comes to %2 at the start of an episode")
      .arg(QString::number(line), values.join(QStringLiteral(", ")));
}

void RobotPage::setAside() {
  const QString name = fileName(), path = source_.setAside(text_->toPlainText());
  if (!path.isEmpty())
    Q_EMIT told(tr("What was not saved of %1 is in %2; undo brings it back, too.").arg(name, shortPath(path)));
}

void RobotPage::beginLike(const QString& name) {
  everShown_ = chosen_ = true;
  if (!registry_.files) return;
  RobotSource shelf{QString()};
  const auto text = shelf.open(toText(registry_.files->shelvedPath(name.toStdString())));
  if (!text) return Q_EMIT refused(toText(text.error().message));
  beginWith(*text);
}

/// A text without a file.
void RobotPage::beginWith(const QString& text) {
  everShown_ = true;
  setAside();
  source_.begin(text);
  begin(text);
  text_->setFocus(Qt::OtherFocusReason);
}

bool RobotPage::isEdited() const {
  return source_.isEdited(text_->toPlainText());
}

QString RobotPage::fileName() const {
  return source_.path().isEmpty() ? tr("a new robot") : QFileInfo(source_.path()).fileName();
}

void RobotPage::focusHome() {
  text_->setFocus(Qt::OtherFocusReason);
}

bool RobotPage::save() {
  if (source_.path().isEmpty()) return saveAs();
  const Status s = source_.saveTo(source_.path(), text_->toPlainText());
  if (!s) Q_EMIT refused(toText(s.error().message));
  refresh();
  return static_cast<bool>(s);
}

/// A robot that was begun like another and still has that one's name and title gets those of its file.
void RobotPage::nameAfter(const QString& path) {
  if (!checked_ || wrong_ || text_->toPlainText() != checked_->text) return;
  const auto known = registry_.files ? registry_.files->shelved() : std::vector<std::string>();
  if (std::find(known.begin(), known.end(), checked_->inspection.name) == known.end()) return;
  static const QRegularExpression kOther(QStringLiteral("[^a-z0-9-]+"));
  const QString name = QFileInfo(path).completeBaseName().toLower().replace(kOther, QStringLiteral("-")).left(40);
  if (name.isEmpty()) return;
  QString title = QString(name).replace(u'-', u' ');
  title[0] = title[0].toUpper();
  text_->setHead(QStringLiteral("name"), name);
  text_->setHead(QStringLiteral("title"), title);
}

bool RobotPage::saveAs() {
  const QString name = checked_ ? toText(checked_->inspection.name) : QStringLiteral("robot");
  askForNewFile(this, tr("Save the robot"), name + QStringLiteral(".toml"), tr("Robots (*.toml)"),
                QStringLiteral(".toml"), [this](const QString& path) {
                  nameAfter(path);
                  if (const Status s = source_.saveTo(path, text_->toPlainText()); !s)
                    Q_EMIT refused(toText(s.error().message));
                  refresh();
                });
  return !isEdited();
}

}  // namespace surefoot
