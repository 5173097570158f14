// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/prediction_result.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <cmath>

#include "ui/controls/labels.h"
#include "ui/language/numbers.h"
#include "ui/lessons/driver/lesson_driver.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/announce.h"

namespace surefoot {

namespace {

constexpr double kVeryClose = 0.02;  // of the range that could be said

QString numberText(double value) {
  return localNumbers(lessonNumber(value));
}

}  // namespace

bool PredictionResult::there(const LessonDriver& driver) {
  const std::size_t before = driver.number() - 1;
  return driver.number() > 0 && driver.lesson().steps[before].predict && driver.predicted(before) &&
         driver.observed(before);
}

PredictionResult::PredictionResult(const LessonDriver& driver, QWidget* parent) : QWidget(parent) {
  const std::size_t before = driver.number() - 1;
  const LessonPrediction& asked = *driver.lesson().steps[before].predict;
  const double said = *driver.predicted(before), came = *driver.observed(before), difference = std::abs(came - said);
  const QString unit = toText(asked.unit);
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(row);
  whenScaled(this, [column] { column->setSpacing(scaled(8)); });
  row->addWidget(makeText(tr("You said"), 13, 400, false, this), 0, Qt::AlignBottom);
  addNumber(*row, said, false);
  row->addWidget(makeText(tr("and it came to"), 13, 400, false, this), 0, Qt::AlignBottom);
  addNumber(*row, came, asked.of.text == "falls");
  if (!unit.isEmpty()) row->addWidget(makeText(unit + '.', 13, 400, false, this), 0, Qt::AlignBottom);
  row->addStretch(1);
  const QString sentence = difference <= kVeryClose * (asked.high - asked.low) ? tr("Very close.")
                           : came > said ? tr("%1 more than you said.").arg(numberText(difference))
                                         : tr("%1 fewer than you said.").arg(numberText(difference));
  QLabel* label = makeText(sentence, 11, 400, true, this);
  column->addWidget(label);
  announce(*label, tr("You said %1. It came to %2 %3. %4").arg(numberText(said), numberText(came), unit, sentence));
}

void PredictionResult::addNumber(QHBoxLayout& row, double value, bool falls) {
  QLabel* label = falls ? new FallLabel(24, 500, this) : makeText({}, 24, 500, false, this);
  label->setText(numberText(value));
  row.addWidget(label, 0, Qt::AlignBottom);
}

}  // namespace surefoot

#include "moc_prediction_result.cpp"
