// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/teacher/teacher_window.h"

#include <QDirIterator>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "core/files/read_file.h"
#include "ui/controls/hairline.h"
#include "ui/controls/labels.h"
#include "ui/language/from_core.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

constexpr int kReadEvery = 2;  // [s]

struct AnswerWords {
  QString operator()(const NumberQuestion& q) const { return toText(q.answer.text + " " + q.unit); }
  QString operator()(const ChoiceQuestion& q) const {
    return QStringLiteral("%1  %2\n%3").arg(q.answer + 1).arg(toText(q.options[q.answer]), toText(q.why)).trimmed();
  }
  QString operator()(const OrderQuestion& q) const {
    QStringList words;
    for (const std::size_t i : q.answer) words << toText(q.options[i]);
    return words.join(QStringLiteral(" · "));
  }
  QString operator()(const PointQuestion& q) const { return toText(q.accept.text); }
  QString operator()(const WordsQuestion& q) const { return toText(q.model); }
  QString operator()(const CompareQuestion&) const { return TeacherWindow::tr("as the interval says"); }
};

QString wordsOf(const LessonAction& action) {
  switch (action.kind) {
    case LessonAction::Kind::Set:
      return QStringLiteral("%1 = %2").arg(toText(action.key), toText(action.value));
    case LessonAction::Kind::Restart:
      return TeacherWindow::tr("start again");
    case LessonAction::Kind::Transfer:
      return TeacherWindow::tr("a new life with what it has learned");
    case LessonAction::Kind::Run:
      return TeacherWindow::tr("let it run");
    case LessonAction::Kind::Push:
      return TeacherWindow::tr("push it");
    case LessonAction::Kind::Place:
      return TeacherWindow::tr("put it somewhere");
    default:
      return toText(action.value);
  }
}

QString minutesText(double seconds) {
  const auto whole = static_cast<int>(seconds);
  return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

}  // namespace

QString answerOf(const LessonStep& step) {
  if (step.ask) return std::visit(AnswerWords{}, *step.ask);
  QStringList words;
  for (const LessonAction& action : step.solution) words << wordsOf(action);
  return words.join(QStringLiteral(", "));
}

TeacherWindow::TeacherWindow(Lesson lesson, QString classFolder, QWidget* parent)
    : QDialog(parent, Qt::Window),
      lesson_(std::move(lesson)),
      folder_(std::move(classFolder)) {
  setWindowTitle(tr("Teacher: %1").arg(toText(lesson_.title)));
  setModal(false);
  auto* row = new QHBoxLayout(this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  title_ = addText(*column, 13, 500, false);
  time_ = addText(*column, 11, 400, true);
  say_ = addText(*column, 13, 400, false);
  answer_ = addText(*column, 13, 500, false);
  hint_ = addText(*column, 11, 400, true);
  most_ = addText(*column, 13, 400, false);
  next_ = addText(*column, 11, 400, true);
  column->addWidget(new Hairline(Qt::Horizontal));
  notes_ = addText(*column, 13, 400, false);
  column->addStretch(1);
  scroll->setWidget(left);
  row->addWidget(scroll, 1);
  auto* right = new QVBoxLayout;
  state_ = addText(*right, 11, 400, true);
  makeTable(*right);
  if (folder_.isEmpty()) right->addStretch(1);
  row->addLayout(right, 1);
  whenScaled(this, [this, column] {
    column->setSpacing(scaled(8));
    resize(scaled(QSize(900, 560)));
  });
  connect(&ticking_, &QTimer::timeout, this, &TeacherWindow::tick);
  ticking_.start(1000);
  follow(0, -1);
  read();
}

QLabel* TeacherWindow::addText(QVBoxLayout& column, int pixels, int weight, bool quiet) {
  QLabel* label = makeText({}, pixels, weight, quiet, nullptr);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column.addWidget(label);
  return label;
}

void TeacherWindow::makeTable(QVBoxLayout& column) {
  table_ = new QTableWidget(this);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setAccessibleName(tr("Answers of the class"));
  table_->setColumnCount(static_cast<int>(lesson_.steps.size()));
  QStringList heads;
  for (std::size_t i = 0; i < lesson_.steps.size(); ++i) heads << QString::number(i + 1);
  table_->setHorizontalHeaderLabels(heads);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  column.addWidget(table_, 1);
  table_->setVisible(!folder_.isEmpty());
  if (folder_.isEmpty()) state_->setText(tr("No class: answers of a class come in here (Lessons › Class …)."));
}

QString TeacherWindow::notes() const {
  return notes_->text();
}

void TeacherWindow::follow(std::size_t step, double seconds) {
  before_ = seconds;
  step_ = std::min(step, lesson_.steps.size() - 1);
  inStep_.start();
  const LessonStep& now = lesson_.steps[step_];
  title_->setText(tr("Step %1 of %2: %3").arg(step_ + 1).arg(lesson_.steps.size()).arg(toText(now.title)));
  say_->setText(toText(questionOf(now)));
  const QString answer = answerOf(now);
  answer_->setText(answer.isEmpty() ? QString() : tr("Answer: %1").arg(answer));
  hint_->setText(now.hint.empty() ? QString() : tr("Hint: %1").arg(toText(now.hint)));
  next_->setText(
      step_ + 1 < lesson_.steps.size()
          ? tr("Next: %1 (%2)").arg(toText(lesson_.steps[step_ + 1].title), fromCore(kindOf(lesson_.steps[step_ + 1])))
          : tr("This is the last step."));
  QStringList notes = {toText(lesson_.notes)};
  for (const std::string& ask : lesson_.discuss) notes << tr("Ask: %1").arg(toText(ask));
  notes_->setText(notes.join(QStringLiteral("\n\n")));
  for (QLabel* label : {say_, answer_, hint_}) label->setVisible(!label->text().isEmpty());
  show(class_);
  tick();
}

void TeacherWindow::tick() {
  const double minutes = lesson_.steps[step_].minutes;
  const QString planned = minutes > 0 ? tr(" of about %1").arg(minutesText(60 * minutes)) : QString();
  if (before_ < 0) return time_->setText(tr("about %1").arg(minutesText(60 * minutes)));
  time_->setText(tr("%1%2").arg(minutesText(before_ + static_cast<double>(inStep_.elapsed()) / 1000), planned));
  if (!folder_.isEmpty() && inStep_.elapsed() / 1000 % kReadEvery == 0 && !reading_.busy()) read();
}

/// The hand-ins of the class, in the background: the folder may be a slow one.
void TeacherWindow::read() {
  if (folder_.isEmpty()) return;
  auto handIns = std::make_shared<std::vector<HandIn>>();
  reading_.start(
      [handIns, folder = folder_](const std::atomic<bool>& interrupted) {
        constexpr std::size_t kMost = 500;
        QDirIterator files(folder, {QStringLiteral("*.jsonl")}, QDir::Files);
        while (files.hasNext() && handIns->size() < kMost && !interrupted) {
          const auto text = readText(files.next().toStdString());
          auto handIn = text ? parseHandIn(*text) : Result<HandIn>(Error{"none"});
          if (handIn) handIns->push_back(std::move(*handIn));
        }
      },
      [this, handIns] {
        class_ = classTableOf(lesson_, *handIns);
        show(class_);
      });
}

void TeacherWindow::show(const ClassTable& table) {
  if (folder_.isEmpty()) return most_->setVisible(false);
  const bool gone = !QDir(folder_).exists();
  state_->setText(gone ? tr("The class's folder is gone: %1").arg(folder_)
                       : tr("%n students, %1", nullptr, static_cast<int>(table.students.size())).arg(folder_));
  table_->setRowCount(static_cast<int>(table.students.size()));
  for (std::size_t row = 0; row < table.students.size(); ++row) {
    table_->setVerticalHeaderItem(static_cast<int>(row), new QTableWidgetItem(toText(table.students[row])));
    for (std::size_t step = 0; step < table.cells[row].size(); ++step) {
      const ClassCell& cell = table.cells[row][step];
      const QString sign = cell.state == ClassCell::State::Right   ? QStringLiteral("✓")
                           : cell.state == ClassCell::State::Wrong ? QStringLiteral("✗ ")
                                                                   : QString();
      const bool plain = cell.state == ClassCell::State::Right;
      table_->setItem(static_cast<int>(row), static_cast<int>(step),
                      new QTableWidgetItem(plain ? sign : sign + toText(cell.text)));
    }
  }
  if (step_ >= table.steps.size()) return;
  const ClassStep& now = table.steps[step_];
  most_->setText(tr("%1 have answered. %2").arg(now.answered).arg(toText(now.mostSay)));
  most_->setVisible(true);
}

}  // namespace surefoot

#include "moc_teacher_window.cpp"
