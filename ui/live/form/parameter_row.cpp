// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/form/parameter_row.h"

#include <QAccessible>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "core/text/number_text.h"
#include "ui/controls/combo.h"
#include "ui/controls/slider.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

/// Linear near 0, logarithmic far from it, on both sides: ±ln(1 + |v|/bend).
double bent(double value, double bend) {
  return std::copysign(std::log1p(std::abs(value) / bend), value);
}
double unbent(double place, double bend) {
  return std::copysign(bend * std::expm1(std::abs(place)), place);
}

}  // namespace

ParameterRow::ParameterRow(const Parameter& parameter, const std::string& policy, QWidget* parent)
    : Painted(parent),
      parameter_(parameter),
      policy_(policy),
      value_(parameter.fallback) {
  const QString name = fromCore(parameter_.title);
  if (parameter_.kind == Kind::Choice) {
    choice_ = new Combo(name, this);
    for (const std::string& c : parameter_.choices) choice_->addItem(fromCore(c));
    connect(choice_, &QComboBox::activated, this, [this](int index) { Q_EMIT edited(toText(parameter_.key), index); });
  } else {
    slider_ = new Slider(this);
    slider_->setAccessibleName(name);
    connect(slider_, &QSlider::valueChanged, this, &ParameterRow::sliderMoved);
    makeNumber(name);
  }
  makeReset(name);
  forget_.setSingleShot(true);
  connect(&forget_, &QTimer::timeout, this, &ParameterRow::forgetRefusal);
  showTips();
  whenScaled(this, [this] {
    if (number_) number_->setFont(scaledFont(13, value_ == base_ ? 400 : 500));
    if (number_ && shown_ && !number_->isModified()) number_->setText(textOf(value_));
    layOut();
  });
}

void ParameterRow::makeNumber(const QString& name) {
  number_ = new QLineEdit(this);
  number_->setAccessibleName(tr("%1, number").arg(name));
  number_->setFrame(false);
  number_->setAlignment(Qt::AlignRight);
  number_->setTextMargins(0, 0, 0, 0);
  number_->setFocusPolicy(Qt::TabFocus);  // a click is handled here, because a press may begin a drag
  number_->setCursor(Qt::SizeHorCursor);
  number_->installEventFilter(this);
  connect(number_, &QLineEdit::editingFinished, this, &ParameterRow::numberTyped);
}

bool ParameterRow::logarithmic() const {
  return parameter_.sliderLow > 0 && parameter_.sliderHigh / parameter_.sliderLow >= 50;
}

double ParameterRow::valueAt(int position) const {
  const double share = static_cast<double>(position) / Slider::kSteps;
  const double low = parameter_.sliderLow, high = parameter_.sliderHigh;
  if (position == 0) return low;
  if (position == Slider::kSteps) return high;
  const double bend = parameter_.sliderBend;
  double value = bend > 0        ? unbent(bent(low, bend) + share * (bent(high, bend) - bent(low, bend)), bend)
                 : logarithmic() ? low * std::pow(high / low, share)
                                 : low + share * (high - low);
  // Round numbers: three digits of the range, whole numbers where the parameter has no others.
  const double unit = parameter_.kind == Kind::Integer ? 1.0
                      : logarithmic() || bend > 0
                          ? std::pow(10.0, std::floor(std::log10(std::max(std::abs(value), 1e-9))) - 1)
                          : std::pow(10.0, std::floor(std::log10(high - low)) - 2);
  value = std::round(value / unit) * unit;
  return std::clamp(value, low, high);
}

int ParameterRow::sliderAt(double value) const {
  const double low = parameter_.sliderLow, high = parameter_.sliderHigh;
  const double v = std::clamp(value, low, high);
  const double bend = parameter_.sliderBend;
  const double share = bend > 0        ? (bent(v, bend) - bent(low, bend)) / (bent(high, bend) - bent(low, bend))
                       : logarithmic() ? std::log(v / low) / std::log(high / low)
                                       : (v - low) / (high - low);
  return static_cast<int>(std::lround(share * Slider::kSteps));
}

// As many decimals as the range asks for, more if the value has them, so that a column of numbers stands still.
QString ParameterRow::textOf(double value) const {
  int decimals = 0;
  if (parameter_.kind == Kind::Real && parameter_.sliderHigh - parameter_.sliderLow < 32)
    decimals = parameter_.sliderHigh >= 2 ? 1 : 2;
  const auto exact = [&] { return std::abs(value - QString::number(value, 'f', decimals).toDouble()) < 1e-12; };
  while (parameter_.kind == Kind::Real && decimals < 4 && !exact()) ++decimals;
  const auto written = [&](char format, int precision) {
    QString text = QString::number(value, format, precision);
    return localNumbers(text.replace(QStringLiteral("e-0"), QStringLiteral("e-"))
                            .replace(QStringLiteral("e+0"), QStringLiteral("e"))
                            .replace('-', QChar(0x2212)));
  };
  const auto fits = [&](const QString& text) {
    return !number_ || number_->fontMetrics().horizontalAdvance(text) <= scaled(kNumberRoom) - 4;
  };
  const double shown = QString::number(value, 'f', decimals).toDouble();
  const bool precise = value == 0.0 || std::abs(shown / value - 1.0) < 0.01;
  const QString plain = decimals == 0 ? countNumber(value) : written('f', decimals);
  if (precise && fits(plain)) return plain;
  const QString text = written('g', 3);
  return fits(text) ? text : written('e', 1);
}

void ParameterRow::show(double value, double base, std::optional<std::int64_t> changedAt) {
  if (value == base) changedAt.reset();
  // The row may show another value now: a typed one, or a slider at a position that is not allowed.
  const bool moved = number_ && (number_->isModified() || slider_->value() != sliderAt(value));
  if (shown_ && !moved && value == value_ && base == base_ && changedAt == changedAt_) return;
  shown_ = true;
  value_ = value;
  base_ = base;
  changedAt_ = changedAt;
  if (choice_) {
    const QSignalBlocker blocker(choice_);
    choice_->setCurrentIndex(static_cast<int>(value));
  } else {
    const QSignalBlocker blockSlider(slider_), blockNumber(number_);
    if (!slider_->isSliderDown()) slider_->setValue(sliderAt(value));
    number_->setFont(scaledFont(13, value == base ? 400 : 500));
    const QString text = textOf(value);
    const bool typing = number_->hasFocus() && number_->isModified();
    if (!typing && number_->text() != text) number_->setText(text);
  }
  reset_->setVisible(value != base);
  showTips();
  update();
}

void ParameterRow::showTips() {
  QStringList lines = linesOf(parameter_);
  if (value_ != base_ && shown_) {
    const QString usual = parameter_.kind == Kind::Choice ? valueText(parameter_, base_) : textOf(base_);
    const QString step = changedAt_ ? countNumber(static_cast<double>(*changedAt_)) : QString();
    const QString since = changedAt_ ? tr("Set at step %1; Reset goes back to %2.").arg(step, usual)
                                     : tr("Changed; Reset goes back to %1.").arg(usual);
    lines << since;
    reset_->setToolTip(tipText(since));
    reset_->setAccessibleDescription(since);
  }
  const QString tip = tipText(lines.join('\n'));
  setToolTip(tip);
  setWhatsThis(tip);
  for (QWidget* part : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(number_), static_cast<QWidget*>(choice_)})
    if (part) part->setToolTip(tip);
}

void ParameterRow::setInForce(const std::string& policy) {
  inForce_ = policy;
  update();
}

void ParameterRow::sliderMoved(int position) {
  number_->setModified(false);
  const double value = valueAt(position);
  if (value != value_) Q_EMIT edited(toText(parameter_.key), value);
}

void ParameterRow::numberTyped() {
  if (!number_->isModified()) return;
  number_->setModified(false);
  const std::string text = typedNumber(number_->text().trimmed());
  Parameter named = parameter_;  // the form says "Exploration", not policy.epsilon
  named.key = fromCore(parameter_.title).toStdString();
  const Result<double> value = parseValue(named, text);
  if (value) {
    forgetRefusal();
    Q_EMIT edited(toText(parameter_.key), *value);
  } else {
    const NumberText number = readNumberText(text, parameter_.unit);
    QStringList readings;
    for (const std::string& reading : number.readings) readings << localNumbers(reading);
    const bool whole = parameter_.kind == Kind::Integer && number.good && number.value != std::floor(number.value);
    const QString range =
        tr("%1 to %2").arg(localNumbers(boundText(parameter_.low)), localNumbers(boundText(parameter_.high)));
    tellRefused(!readings.isEmpty() ? readings.join(tr(" or ")) + '?'
                : !number.good      ? tr("no number")
                : whole             ? tr("a whole number")
                                    : range,
                toText(value.error().message));
    Q_EMIT refused(toText(value.error().message));
  }
  number_->setText(textOf(value_));
}

void ParameterRow::tellRefused(const QString& words, const QString& sentence) {
  constexpr int kStays = 8000;  // [ms]
  refusal_ = words;
  forget_.start(kStays);
  if (slider_) slider_->hide();  // its place is needed for the words
  setToolTip(tipText(sentence));
  QWidget* field = number_ ? static_cast<QWidget*>(number_) : choice_;
  field->setToolTip(tipText(sentence));
  field->setAccessibleDescription(sentence);
  QAccessibleEvent event(field, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&event);
  update();
}

void ParameterRow::forgetRefusal() {
  if (refusal_.isEmpty()) return;
  refusal_.clear();
  forget_.stop();
  if (slider_) slider_->show();
  (number_ ? static_cast<QWidget*>(number_) : choice_)->setAccessibleDescription({});
  showTips();
  update();
}

}  // namespace surefoot

#include "moc_parameter_row.cpp"
