// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/questions/prediction_box.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

#include "core/text/text.h"
#include "ui/controls/decimal_box.h"
#include "ui/controls/labels.h"
#include "ui/controls/slider.h"
#include "ui/controls/text_button.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

PredictionBox::PredictionBox(LessonDriver& driver, QWidget* parent)
    : QuestionBox(driver, tr("Your prediction"), parent) {
  const LessonPrediction& p = *driver.step().predict;
  addQuestion(toText(p.question));
  const bool whole = p.high - p.low >= 10;
  number_ = new DecimalBox(this);
  number_->setDecimals(whole ? 0 : 2);
  number_->setRange(p.low, p.high);
  number_->setSingleStep(whole ? 1 : (p.high - p.low) / 100);
  number_->setAccessibleName(toText(p.question));
  number_->setKeyboardTracking(true);
  number_->setAlignment(Qt::AlignRight);
  QLabel* unit = makeText(toText(p.unit), 11, 400, true, this);
  whenScaled(number_, [this] {
    number_->setFont(scaledFont(24, 500));
    number_->setFixedSize(scaled(QSize(112, 42)));
  });
  auto* row = new QHBoxLayout;
  row->addWidget(number_);
  row->addWidget(unit);
  row->addStretch(1);
  column().addLayout(row);
  slider_ = new Slider(this);
  slider_->setAccessibleName(tr("The same as a slider"));
  column().addWidget(slider_);
  auto* ends = new QHBoxLayout;
  // As many numbers as are whole.
  const auto isWhole = [&](int part) { return std::fmod(p.high - p.low, part) == 0; };
  const int parts = !whole || isWhole(4) ? 4 : isWhole(2) ? 2 : 1;
  for (int i = 0; i <= parts; ++i) {
    const double at = p.low + (p.high - p.low) * i / parts;
    if (i > 0) ends->addStretch(1);
    ends->addWidget(makeText(localNumbers(whole ? countText(at) : fixedText(at, 2)), 11, 400, true, this));
  }
  column().addLayout(ends);
  commit_ = new TextButton({}, TextButton::Look::Main, this);
  whenScaled(commit_, [this] { commit_->setMinimumHeight(scaled(32)); });
  column().addWidget(commit_);
  note_ = addNote(tr("%1 to %2; type it, or drag the mark. Once given it stays. Wrong is fine.")
                      .arg(localNumbers(whole ? countText(p.low) : fixedText(p.low, 2)),
                           localNumbers(whole ? countText(p.high) : fixedText(p.high, 2))));
  connect(number_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    const LessonPrediction& asked = *driver_.step().predict;
    const QSignalBlocker blocker(slider_);
    slider_->setValue(static_cast<int>(std::lround(Slider::kSteps * (value - asked.low) / (asked.high - asked.low))));
    refresh();
    Q_EMIT predictionMoved(value);
  });
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    const LessonPrediction& asked = *driver_.step().predict;
    const double value = asked.low + (asked.high - asked.low) * position / Slider::kSteps;
    number_->setValue(number_->decimals() == 0 ? std::round(value) : value);
  });
  number_->installEventFilter(this);
  setFirst(number_);
  connect(commit_, &QAbstractButton::clicked, this, [this] { driver_.say(number_->value()); });
  connect(&driver_, &LessonDriver::phaseChanged, this, &PredictionBox::refresh);
  setValue(driver.predicted(driver.number()).value_or((p.low + p.high) / 2));
  refresh();
}

/// Enter commits.
bool PredictionBox::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QuestionBox::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent&>(*event).key();
  if (key != Qt::Key_Return && key != Qt::Key_Enter) return QuestionBox::eventFilter(watched, event);
  number_->interpretText();
  commit_->click();
  return true;
}

double PredictionBox::value() const {
  return number_->value();
}

void PredictionBox::setValue(double value) {
  number_->setValue(value);
}

QString PredictionBox::said() const {
  const double value = number_->value();
  const QString number = localNumbers(number_->decimals() == 0 ? countText(value) : fixedText(value, 2));
  return tr("%1 %2").arg(number, toText(driver_.step().predict->unit)).trimmed();
}

void PredictionBox::refresh() {
  if (!driver_.step().predict) return;
  const bool given = driver_.predicted(driver_.number()).has_value();
  for (QWidget* control : {static_cast<QWidget*>(number_), static_cast<QWidget*>(slider_)}) control->setEnabled(!given);
  commit_->setEnabled(!given && driver_.phase() == LessonDriver::Phase::Open);
  commit_->setText(given ? tr("You said %1").arg(said()) : tr("Commit to %1").arg(said()));
}

}  // namespace surefoot

#include "moc_prediction_box.cpp"
