// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/robot/robot_page.h"

#include <fmt/format.h>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
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
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr int kCheckAfter = 300, kKeepAfter = 1000;  // [ms] of no typing
constexpr std::chrono::milliseconds kPatience(95);

}  // namespace

RobotPage::RobotPage(const Registry& registry, const QString& folder, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      source_(folder) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal));
  auto* body = new QWidget;
  auto* row = new QHBoxLayout(body);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(makeDescription(), 416);
  row->addWidget(new Hairline(Qt::Vertical));
  auto* right = new QVBoxLayout;
  right->setSpacing(0);
  right->addWidget(makeWorld(), 448);
  right->addWidget(new Hairline(Qt::Horizontal));
  right->addWidget(makeLife(), 256);
  row->addLayout(right, 864);
  auto* scroll = new QScrollArea;  // on the smallest screens
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(body);
  column->addWidget(scroll, 1);

  pause_.setSingleShot(true);
  pause_.setInterval(kCheckAfter);
  keeping_.setSingleShot(true);
  keeping_.setInterval(kKeepAfter);
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    pause_.start();
    keeping_.start();
    refresh();
  });
  connect(&pause_, &QTimer::timeout, this, &RobotPage::check);
  connect(&keeping_, &QTimer::timeout, this, [this] { source_.keep(text_->toPlainText()); });
  connect(&checking_, &Background::failed, this, &RobotPage::refused);
  connect(text_, &RobotText::lineChanged, picture_, &RobotPicture::setLine);
  connect(text_, &RobotText::lineChanged, this, &RobotPage::refresh);
  connect(text_, &RobotText::helpAsked, this, &RobotPage::explain);
  connect(picture_, &RobotPicture::lineAsked, this, [this](int line) { text_->goTo({line, 1}); });
  connect(picture_, &RobotPicture::limitMoved, this, &RobotPage::writeLimit);
  connect(picture_, &RobotPicture::keyPressed, this, [this](int key) {
    if (key == Qt::Key_Escape) return trial_.stop();
    trial_.press(key);
  });
  connect(table_, &StateTable::lineAsked, this, [this](int line) { text_->goTo({line, 1}); });
  connect(table_, &StateTable::rangeProposed, this, &RobotPage::writeRange);
  connect(life_, &RandomLife::fallAsked, this, [this](int fall) {
    const auto& seen = checked_->inspection;
    const int step = seen.falls[static_cast<std::size_t>(fall)];
    const auto begin = std::lower_bound(seen.begins.begin(), seen.begins.end(), step);
    trial_.replay(*checked_->file, *std::prev(begin), step);
    refresh();
  });
  connect(&trial_, &RobotTrial::moved, this, [this](const Scene& scene) { picture_->setMoving(scene); });
  connect(&trial_, &RobotTrial::stopped, this, [this] {
    picture_->setMoving(std::nullopt);
    refresh();
  });
  connect(&source_, &RobotSource::changedOnDisk, this, [this](const QString& text, const QString& before) {
    if (text_->toPlainText() != before) setAside();
    text_->replaceAll(text);
    Q_EMIT told(tr("%1 was saved by another program, and is shown as it is now; undo brings back what was here.")
                    .arg(fileName()));
  });
  refresh();
}

void RobotPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (std::exchange(everShown_, true)) return;
  const auto draft = source_.draft();
  if (!draft) {
    beginLike(QStringLiteral("segway"));
    chosen_ = false;
    return;
  }
  if (draft->path.isEmpty() || !source_.open(draft->path)) source_.begin(QString());
  text_->replaceAll(draft->text);
  check();
  Q_EMIT told(tr("What was not saved of %1 is here again.").arg(fileName()));
}

void RobotPage::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  trial_.stop();
  source_.keep(text_->toPlainText());
}

void RobotPage::check() {
  auto made = std::make_shared<Checked>();
  made->text = text_->toPlainText();
  const std::string folder = QFileInfo(source_.path()).absolutePath().toStdString();
  checking_.start(
      [made, folder, library = registry_.files](const std::atomic<bool>&) {
        made->file = library->read(made->text.toStdString(), folder, made->complaints);
        if (!made->file) return;
        made->file->text = made->text.toStdString();
        made->inspection = made->file->inspect();
      },
      [this, made] { take(made); }, kPatience);
}

void RobotPage::take(const std::shared_ptr<Checked>& checked) {
  wrong_ = !checked->file;
  text_->setComplaints(checked->complaints);
  if (checked->file) {
    trial_.stop();
    checked_ = checked;
    showInspection(&checked_->inspection);
    lines_->setToolTip({});
  }
  refresh();
}

void RobotPage::refresh() {
  file_->setText(fileName() + QStringLiteral("  ▾"));
  file_->setAccessibleName(tr("Robot: %1").arg(fileName()));
  file_->updateGeometry();
  state_->setText(isEdited() ? tr("changed, not saved") : source_.path().isEmpty() ? tr("not saved yet") : QString());
  note_->setText(!wrong_    ? QString()
                 : checked_ ? tr("picture and table: as of the last text without an error")
                            : tr("picture and table come when the text has no error"));
  const auto errors = static_cast<int>(text_->complaints().size());
  errors_->setText(errors == 0 ? QString() : tr("%n errors", nullptr, errors));
  QPalette caution = palette();
  caution.setColor(QPalette::WindowText, themeOf(*this).caution);
  errors_->setPalette(caution);
  errors_->adjustSize();
  textHead_->layOutExtra();
  const auto warnings = checked_ ? static_cast<int>(checked_->inspection.warnings.size()) : 0;
  const QString value = valueAtCaret();
  QString foot =
      errors > 0 ? text_->anyProposal() ? tr("F8 the next error, Alt+Enter mends it") : tr("F8 the next error")
      : !value.isEmpty()
          ? value
          : tr("%n lines; F1 says what the word at the caret means", nullptr, text_->document()->blockCount());
  if (errors == 0 && value.isEmpty() && warnings > 0) {
    const Complaint& first = checked_->inspection.warnings.front();
    foot = tr("line %1: %2").arg(QString::number(first.at.line), toText(first.sentence));
    if (warnings > 1) foot += tr(" (and %1 more)").arg(warnings - 1);
    QStringList all;
    for (const Complaint& w : checked_->inspection.warnings)
      all << tr("line %1: %2").arg(QString::number(w.at.line), toText(w.sentence));
    lines_->setToolTip(tipText(all.join(u'\n')));
  }
  if (const QString why = checked_ ? toText(checked_->inspection.unanswered) : QString(); !why.isEmpty()) {
    foot = why;
    lines_->setToolTip(tipText(why));
  }
  lines_->setText(foot);
  refreshProgram();
  save_->setEnabled(isEdited() || source_.path().isEmpty());
  try_->setText(trial_.isRunning() ? tr("Stop") : tr("Try"));
  try_->setStarts(!trial_.isRunning());
  learn_->setEnabled(checked_ && !wrong_);
  handMade_->setVisible(trial_.handMade());
  worldHead_->setNote(trial_.isRunning() ? trial_.words()
                                         : tr("names and limits under the pointer; a click goes to the line"));
  worldHead_->layOutExtra();
  Q_EMIT statusChanged(source_.path().isEmpty() ? tr("a robot that is not saved yet") : shortPath(source_.path()),
                       checked_ ? tr("%1 tiles a tiling").arg(countNumber(checked_->inspection.tiles)) : QString());
}

void RobotPage::undo() {
  text_->undo();
}

void RobotPage::redo() {
  text_->redo();
}

// Degrees to the nearest whole one, written in radians as people write them: 30 / 180 * pi would be an expression, and
// a number is what can be dragged again.
void RobotPage::writeLimit(const AngleHandle& handle, double angle) {
  if (!handle.number || wrong_ || text_->toPlainText() != checked_->text) return;
  static const QRegularExpression kNumber(QStringLiteral("^[-+0-9.eE_]+"));
  const auto number = kNumber.match(text_->lineFrom(*handle.number));
  if (!number.hasMatch()) return;
  text_->write(*handle.number, static_cast<int>(number.capturedLength()), toText(fmt::format("{:.4g}", angle)));
  text_->goTo(*handle.number);
  pause_.stop();
  check();
}

void RobotPage::writeRange(const SeenState& state) {
  if (wrong_ || text_->toPlainText() != checked_->text) return;
  static const QRegularExpression kRange(QStringLiteral("^\\[[^\\]]*\\]"));
  const auto range = kRange.match(text_->lineFrom(state.rangeAt));
  if (!range.hasMatch()) return;
  text_->write(state.rangeAt, static_cast<int>(range.capturedLength()),
               toText(fmt::format("[{:.4g}, {:.4g}]", state.proposedLow, state.proposedHigh)));
  text_->goTo(state.rangeAt);
  pause_.stop();
  check();
}

void RobotPage::tryOut() {
  if (trial_.isRunning()) return trial_.stop();
  trial_.start(*checked_->file, RobotTrial::Mode::Random);
  picture_->setFocus(Qt::OtherFocusReason);
  refresh();
}

void RobotPage::learn() {
  if (isEdited() && !source_.path().isEmpty() && !save()) return;
  const std::string text = text_->toPlainText().toStdString();
  const auto file = source_.path().isEmpty() ? registry_.files->add(text, fileName().toStdString())
                                             : registry_.files->open(source_.path().toStdString());
  if (!file) return Q_EMIT refused(toText(file.error().message));
  trial_.stop();
  Q_EMIT learnAsked((*file)->entry.name);
}

}  // namespace surefoot

#include "moc_robot_page.cpp"
