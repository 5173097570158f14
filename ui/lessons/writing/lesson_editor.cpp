// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/writing/lesson_editor.h"

#include <QFileInfo>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QShortcut>
#include <QTextBlock>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "core/files/whole_file.h"
#include "core/lessons/reading/lesson_reading.h"
#include "ui/controls/hairline.h"
#include "ui/controls/text_button.h"
#include "ui/language/from_core.h"
#include "ui/lessons/taking/lesson_text.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"

namespace surefoot {

namespace {

constexpr int kCheckAfter = 300;  // [ms] of no typing

QLabel* makeLabel(int pixels, int weight, bool quiet) {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  if (quiet) label->setForegroundRole(QPalette::PlaceholderText);
  whenScaled(label, [label, pixels, weight] { label->setFont(scaledFont(pixels, weight)); });
  return label;
}

/// The question with its options, as plain text.
QString questionText(const LessonStep& step) {
  QString text = toText(questionOf(step));
  const auto options = [&](const std::vector<std::string>& all) {
    for (const std::string& option : all) text += QStringLiteral("\n○  ") + toText(option);
  };
  if (!step.ask) return text;
  if (const auto* choice = std::get_if<ChoiceQuestion>(&*step.ask)) options(choice->options);
  if (const auto* order = std::get_if<OrderQuestion>(&*step.ask)) options(order->options);
  return text;
}

}  // namespace

LessonEditor::LessonEditor(const Registry& registry, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      edit_(new QPlainTextEdit) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeBar());
  column->addWidget(new Hairline(Qt::Horizontal));
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  edit_->setAccessibleName(tr("Lesson"));
  edit_->setFrameShape(QFrame::NoFrame);
  edit_->setTabChangesFocus(true);
  row->addWidget(edit_, 3);
  row->addWidget(new Hairline(Qt::Vertical));
  auto* right = new QVBoxLayout;
  where_ = makeLabel(13, 500, false);
  kind_ = makeLabel(11, 400, true);
  say_ = new MarkdownView;
  question_ = makeLabel(13, 500, false);
  verdict_ = makeLabel(13, 400, false);
  verdict_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  right->addWidget(where_);
  right->addWidget(kind_);
  right->addWidget(say_);
  right->addWidget(question_);
  right->addStretch(1);
  right->addWidget(new Hairline(Qt::Horizontal));
  right->addWidget(verdict_);
  row->addLayout(right, 2);
  column->addLayout(row, 1);
  whenScaled(this, [this, right] {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPixelSize(scaled(12));
    edit_->setFont(fixed);
    right->setContentsMargins(scaled({12, 12, 12, 12}));
    right->setSpacing(scaled(8));
  });
  auto* pause = new QTimer(this);
  pause->setSingleShot(true);
  pause->setInterval(kCheckAfter);
  connect(edit_, &QPlainTextEdit::textChanged, pause, qOverload<>(&QTimer::start));
  connect(pause, &QTimer::timeout, this, &LessonEditor::check);
  connect(edit_, &QPlainTextEdit::cursorPositionChanged, this, &LessonEditor::showStep);
  auto* next = new QShortcut(Qt::Key_F8, this);
  next->setContext(Qt::WidgetWithChildrenShortcut);
  connect(next, &QShortcut::activated, this, &LessonEditor::goToFirst);
}

QWidget* LessonEditor::makeBar() {
  auto* bar = new QWidget;
  auto* row = new QHBoxLayout(bar);
  const auto add = [&](const QString& text, TextButton::Look look, auto slot) {
    auto* button = new TextButton(text, look);
    connect(button, &QAbstractButton::clicked, this, slot);
    row->addWidget(button);
    return button;
  };
  try_ = add(tr("Try it"), TextButton::Look::Main, [this] { Q_EMIT tryAsked(); });
  live_ = add(tr("Live through it"), TextButton::Look::Framed, [this] { liveThrough(); });
  live_->setToolTip(tr("All solutions are lived; what does not come out as the text says is told"));
  add(tr("Save"), TextButton::Look::Framed, [this] { save(); });
  add(tr("Save as …"), TextButton::Look::Framed, [this] { saveAs(); });
  add(tr("All lessons"), TextButton::Look::Framed, [this] { Q_EMIT closeAsked(); });
  name_ = makeLabel(11, 400, true);
  row->addWidget(name_, 1);
  whenScaled(bar, [bar, row] {
    bar->setFixedHeight(scaled(48));
    row->setContentsMargins(scaled({12, 0, 12, 0}));
    row->setSpacing(scaled(8));
  });
  return bar;
}

QString LessonEditor::text() const {
  return edit_->toPlainText();
}

bool LessonEditor::hasEdits() const {
  return text() != saved_;
}

void LessonEditor::edit(const QString& text, const QString& path) {
  path_ = path;
  saved_ = path.isEmpty() ? QString() : text;
  edit_->setPlainText(text);
  edit_->setFocus(Qt::OtherFocusReason);
  check();
}

/// The text is read anew; what was lived through was another text.
void LessonEditor::check() {
  checking_.cancel();
  told_.clear();
  complaints_.clear();
  const std::string name = path_.isEmpty() ? "my-lesson.toml" : path_.toStdString();
  auto read = readLesson(registry_, text().toStdString(), name, complaints_);
  if (read) lesson_ = std::move(*read);
  showComplaints();
  Q_EMIT checked();
}

void LessonEditor::liveThrough() {
  if (!complaints_.empty() || !lesson_) return goToFirst();
  verdict_->setText(tr("It is being lived through …"));
  struct Work {
    Lesson lesson;
    std::vector<Complaint> complaints{};
    std::vector<ToldStep> told{};
  };
  auto work = std::make_shared<Work>(Work{*lesson_});
  checking_.start(
      [work, &registry = registry_](const std::atomic<bool>&) {
        const std::uint64_t seed = work->lesson.seedOfStudent ? 1 : work->lesson.start.seed;
        work->complaints = surefoot::liveThrough(registry, work->lesson, seed, &work->told);
      },
      [this, work] {
        complaints_ = work->complaints;
        told_ = work->told;
        showComplaints();
        Q_EMIT checked();
      });
}

/// Wavy lines in the colour of caution under what is wrong, and the sentences beside the text.
void LessonEditor::showComplaints() {
  constexpr std::size_t kMostShown = 8;
  const Theme& t = themeOf(*this);
  QList<QTextEdit::ExtraSelection> marks;
  QStringList sentences;
  for (const Complaint& complaint : complaints_) {
    if (static_cast<std::size_t>(sentences.size()) < kMostShown)
      sentences << (complaint.at.line > 0 ? tr("Line %1: %2").arg(complaint.at.line).arg(toText(complaint.sentence))
                                          : toText(complaint.sentence));
    const QTextBlock block = edit_->document()->findBlockByNumber(std::max(complaint.at.line, 1) - 1);
    if (complaint.at.line == 0 || !block.isValid()) continue;
    QTextEdit::ExtraSelection mark;
    mark.cursor = QTextCursor(block);
    const int column = std::min(std::max(complaint.at.column, 1) - 1, std::max(0, block.length() - 2));
    mark.cursor.setPosition(block.position() + column);
    mark.cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
    mark.format.setUnderlineColor(t.caution);
    marks << mark;
  }
  edit_->setExtraSelections(marks);
  const QString fine = told_.empty() ? tr("No errors. “Live through it” tries its solutions.")
                                     : tr("Well: all %1 steps were lived through.").arg(told_.size());
  verdict_->setText(sentences.isEmpty() ? fine : sentences.join(QLatin1Char('\n')));
  QPalette palette = verdict_->palette();
  palette.setColor(QPalette::WindowText, sentences.isEmpty() ? t.ink : t.caution);
  verdict_->setPalette(palette);
  try_->setEnabled(complaints_.empty() && lesson_);
  live_->setEnabled(complaints_.empty() && lesson_);
  const QString file = path_.isEmpty() ? tr("not saved yet") : QFileInfo(path_).fileName();
  name_->setText(hasEdits() && !path_.isEmpty() ? tr("%1, changed").arg(file) : file);
  showStep();
}

/// The number (from 0) of the [[step]] that the caret is in; −1: it is before the first.
int LessonEditor::stepAtCaret() const {
  int step = -1;
  for (QTextBlock block = edit_->document()->begin(); block.isValid(); block = block.next()) {
    if (block.text().startsWith(QStringLiteral("[[step]]"))) ++step;
    if (block == edit_->textCursor().block()) break;
  }
  return step;
}

void LessonEditor::showStep() {
  if (!lesson_ || lesson_->steps.empty()) {
    where_->setText(tr("The step under the caret is shown here."));
    return;
  }
  const int step = std::clamp(stepAtCaret(), 0, static_cast<int>(lesson_->steps.size()) - 1);
  const auto at = static_cast<std::size_t>(step);
  const LessonStep& shown = lesson_->steps[at];
  where_->setText(tr("Step %1: %2").arg(step + 1).arg(toText(shown.title)));
  kind_->setText(complaints_.empty() || !told_.empty()
                     ? fromCore(kindOf(shown))
                     : tr("%1; as of the last text without an error").arg(fromCore(kindOf(shown))));
  QString say;
  for (std::size_t i = 0; i < shown.say.between.size(); ++i) {
    say += toText(shown.say.between[i]);
    if (i < shown.say.numbers.size()) say += QStringLiteral("…");
  }
  say_->show(at < told_.size() ? toText(told_[at].say) : say);
  QString below = questionText(shown);
  if (at < told_.size()) below += QStringLiteral("\n\n") + toText(told_[at].came).trimmed();
  question_->setText(below);
}

void LessonEditor::goToFirst() {
  for (const Complaint& complaint : complaints_) {
    if (complaint.at.line == 0) continue;
    QTextCursor cursor(edit_->document()->findBlockByNumber(complaint.at.line - 1));
    edit_->setTextCursor(cursor);
    return edit_->setFocus(Qt::ShortcutFocusReason);
  }
}

void LessonEditor::save() {
  path_.isEmpty() ? saveAs() : writeTo(path_);
}

void LessonEditor::saveAs() {
  const QString suggested = path_.isEmpty() ? QStringLiteral("my-lesson.toml") : QFileInfo(path_).fileName();
  askForNewFile(this, tr("Save the lesson"), suggested, QStringLiteral("*.toml"), QStringLiteral("toml"),
                [this](const QString& path) { writeTo(path); });
}

void LessonEditor::writeTo(const QString& path) {
  const QString now = text();
  if (const Status s = writeWhole("lesson", path.toStdString(), now.toStdString()); !s)
    return Q_EMIT refused(toText(s.error().message));
  path_ = path;
  saved_ = now;
  showComplaints();
  Q_EMIT saved(path);
}

}  // namespace surefoot

#include "moc_lesson_editor.cpp"
