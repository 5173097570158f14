// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/questions/question_boxes.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "core/text/number_text.h"
#include "ui/controls/labels.h"
#include "ui/controls/text_button.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

/// "2 1 3" as places from 0; the order of the file where the text is none.
std::vector<std::size_t> orderOf(const std::string& text, std::size_t size) {
  std::vector<std::size_t> order;
  for (const QString& word : QString::fromStdString(text).split(' ')) order.push_back(word.toUInt() - 1);
  std::vector<std::size_t> asItIs(size);
  std::iota(asItIs.begin(), asItIs.end(), std::size_t{0});
  return std::is_permutation(order.begin(), order.end(), asItIs.begin(), asItIs.end()) ? order : asItIs;
}

/// "policy.epsilon >= 0.01" as "ε ≥ 0.01".
QString plainCondition(const std::string& condition, const Parameters& parameters) {
  QString text = toText(condition);
  for (const auto& entry : parameters.all()) {
    const std::string& symbol = entry.parameter.symbol;
    text.replace(toText(entry.parameter.key), fromCore(symbol.empty() ? entry.parameter.title : symbol));
  }
  return text.replace(QStringLiteral(">="), QStringLiteral("≥")).replace(QStringLiteral("<="), QStringLiteral("≤"));
}

}  // namespace

NumberBox::NumberBox(LessonDriver& driver, const NumberQuestion& question, QWidget* parent)
    : QuestionBox(driver, tr("Work it out"), parent),
      number_(new QLineEdit(this)) {
  addQuestion(toText(question.question));
  auto* row = new QHBoxLayout;
  number_->setAccessibleName(toText(question.question));
  whenScaled(number_, [this] {
    number_->setFont(scaledFont(13));
    number_->setFixedSize(scaled(QSize(112, 32)));
  });
  row->addWidget(number_);
  row->addWidget(new QLabel(toText(question.unit), this));
  row->addStretch(1);
  column().addLayout(row);
  column().addWidget(verdict_);
  number_->setText(localNumbers(driver.draft().answer));
  connect(number_, &QLineEdit::returnPressed, this, [this] { check(); });
  connect(number_, &QLineEdit::textChanged, this, [this](const QString& text) {
    driver_.keepDraft({text.toStdString(), {}});
  });
  connect(&driver, &LessonDriver::judged, number_, &QLineEdit::selectAll);  // so that one types another
  setFirst(number_);
  setNextWord(tr("Check"));
}

void NumberBox::check() {
  const auto value = parseNumber("the answer", typedNumber(number_->text()));
  if (!value) return tell({false, tr("Type a number, such as −4.5.").toStdString()});
  driver_.number(*value);
}

OrderBox::OrderBox(LessonDriver& driver, const OrderQuestion& question, QWidget* parent)
    : QuestionBox(driver, tr("Put them in order"), parent),
      list_(new QListWidget(this)) {
  addQuestion(toText(question.question));
  for (const std::size_t i : orderOf(driver.draft().answer, question.options.size())) {
    auto* item = new QListWidgetItem(toText(question.options[i]), list_);
    item->setData(Qt::UserRole, static_cast<int>(i));
  }
  list_->setDragDropMode(QAbstractItemView::InternalMove);
  list_->setCurrentRow(0);
  list_->setAccessibleName(toText(question.question));
  list_->installEventFilter(this);
  connect(list_->model(), &QAbstractItemModel::rowsMoved, this, &OrderBox::keep);
  connect(list_->model(), &QAbstractItemModel::rowsInserted, this, &OrderBox::keep);
  setFirst(list_);
  setNextWord(tr("Check"));
  whenScaled(list_, [this] {
    list_->setFont(scaledFont(13));
    list_->setFixedHeight(scaled(8 + 28 * list_->count()));
  });
  column().addWidget(list_);
  auto* row = new QHBoxLayout;
  for (const auto& [words, by] : {std::pair(tr("Up"), -1), std::pair(tr("Down"), 1)}) {
    auto* button = new TextButton(words, TextButton::Look::Framed, this);
    connect(button, &QAbstractButton::clicked, this, [this, by] { move(by); });
    row->addWidget(button);
  }
  row->addStretch(1);
  column().addLayout(row);
  addNote(tr("the first on top; drag one, or Alt+↑ and Alt+↓"));
  column().addWidget(verdict_);
}

void OrderBox::move(int by) {
  const int row = list_->currentRow(), to = row + by;
  if (row < 0 || to < 0 || to >= list_->count()) return;
  list_->insertItem(to, list_->takeItem(row));
  list_->setCurrentRow(to);
}

bool OrderBox::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QuestionBox::eventFilter(watched, event);
  const auto& key = static_cast<QKeyEvent&>(*event);
  const bool up = key.key() == Qt::Key_Up, down = key.key() == Qt::Key_Down;
  if (!(key.modifiers() & Qt::AltModifier) || !(up || down)) return QuestionBox::eventFilter(watched, event);
  move(up ? -1 : 1);
  return true;
}

std::vector<std::size_t> OrderBox::order() const {
  std::vector<std::size_t> order;
  for (int row = 0; row < list_->count(); ++row)
    order.push_back(static_cast<std::size_t>(list_->item(row)->data(Qt::UserRole).toInt()));
  return order;
}

void OrderBox::keep() {
  std::string text;
  for (const std::size_t i : order()) text += (text.empty() ? "" : " ") + std::to_string(i + 1);
  driver_.keepDraft({text, {}});
}

void OrderBox::check() {
  driver_.order(order());
}

PointBox::PointBox(LessonDriver& driver, const PointQuestion& question, QWidget* parent)
    : QuestionBox(driver, tr("Point at it"), parent) {
  addQuestion(toText(question.question));
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(toText(question.question));
  if (question.on == PointQuestion::On::Map) {
    addNote(tr("a click on the map answers; on the map, arrows move the cursor and Enter answers"));
    connect(&driver.session().looking(), &Looking::examinedChanged, this, [this] {
      if (driver_.session().looking().pinned()) driver_.point({driver_.session().looking().examined(), 0});
    });
  } else if (question.on == PointQuestion::On::Fall) {
    addNote(tr("a click on its mark answers"));
    connect(&driver.session().looking(), &Looking::fallReplayed, this, [this](std::int64_t episode) {
      driver_.point({{}, static_cast<double>(episode)});
    });
  } else {
    const Task& task = driver.session().life().task();
    auto* group = new QButtonGroup(this);
    for (std::size_t a = 0; a < task.actions.size(); ++a) {
      const QString name = a < task.actionNames.size()
                               ? fromCore(task.actionNames[a])
                               : localNumbers(QString::number(task.actions[a]).replace('-', QChar(0x2212)));
      auto* button = new QRadioButton(name, this);
      group->addButton(button);
      column().addWidget(button);
      connect(button, &QRadioButton::clicked, this, [this, value = task.actions[a]] { driver_.point({{}, value}); });
    }
  }
  column().addWidget(verdict_);
}

WordsBox::WordsBox(LessonDriver& driver, const WordsQuestion& question, QWidget* parent)
    : QuestionBox(driver, tr("Your own words"), parent) {
  addQuestion(toText(question.question));
  text_ = addWords(4, toText(question.question));
  text_->setPlainText(toText(driver.draft().answer));
  connect(text_, &QPlainTextEdit::textChanged, this, [this] {
    driver_.keepDraft({text_->toPlainText().toStdString(), {}});
  });
  setFirst(text_);
  setNextWord(tr("Keep it"));
  model_ = new QWidget(this);
  auto* model = new QVBoxLayout(model_);
  model->setContentsMargins(0, 0, 0, 0);
  model->addWidget(makeHead(tr("One answer"), model_));
  QLabel* answer = makeText(toText(question.model), 13, 400, false, model_);
  answer->setWordWrap(true);
  model->addWidget(answer);
  auto* agrees = new QCheckBox(tr("Mine says the same"), model_);
  connect(agrees, &QCheckBox::toggled, this, [this](bool on) { driver_.words(text_->toPlainText(), on); });
  model->addWidget(agrees);
  model_->setVisible(driver.answered());
  column().addWidget(model_);
  addNote(tr("kept as it is; the program does not mark it"));
}

void WordsBox::check() {
  driver_.words(text_->toPlainText(), std::nullopt);
  verdict_->hide();
  model_->show();
}

TaskBox::TaskBox(LessonDriver& driver, QWidget* parent)
    : QuestionBox(driver, tr("Task"), parent),
      task_(addQuestion(toText(driver.step().task))),
      par_(addNote({})) {
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(toText(driver.step().task));
  column().addWidget(verdict_);
  connect(&driver.session().life(), &RunningLife::replaced, verdict_, &QWidget::hide);
  connect(&driver, &LessonDriver::taskChanged, verdict_, &QWidget::hide);
  connect(&driver, &LessonDriver::taskChanged, this, &TaskBox::refresh);
  connect(&driver, &LessonDriver::stepChanged, this, &TaskBox::refresh);
  refresh();
}

void TaskBox::refresh() {
  const LessonStep& step = driver_.step();
  if (!step.done) return;
  const QString state = driver_.taskDone() ? tr("✓ Done.") : tr("○ Not done yet; it ticks itself.");
  task_->setText(toText(step.task) + '\n' + state);
  if (step.par)
    par_->setText((driver_.parKept() ? tr("✓ And with %1.") : tr("Extra: can you do it with %1?"))
                      .arg(plainCondition(step.par->text, driver_.session().life().configuration().parameters)));
  par_->setVisible(step.par.has_value());
}

}  // namespace surefoot
