// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/parameter_row.h"

#include <QEvent>
#include <QLineEdit>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <cmath>

#include "core/text.h"
#include "ui/combo.h"
#include "ui/slider.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {
constexpr int kRow = 24, kChanged = 18, kName = 20, kUnit = 32, kNumber = 48;  // [px]

QString tip(const Parameter& p) {
  const QString symbol = p.symbol.empty() ? QString() : QStringLiteral(" %1").arg(toText(p.symbol));
  const QString unit = p.unit.empty() ? QString() : QStringLiteral(" [%1]").arg(toText(p.unit));
  return QStringLiteral("<b>%1</b>%2%3<br>%4<br>Allowed: %5. Default: %6 (%7).")
      .arg(toText(p.title), symbol, unit, toText(p.help).toHtmlEscaped(), toText(allowedValues(p)),
           toText(formatValue(p, p.fallback)), toText(p.origin));
}
}  // namespace

ParameterRow::ParameterRow(const Parameter& parameter, const std::string& policy, QWidget* parent)
    : QWidget(parent),
      parameter_(parameter),
      policy_(policy),
      value_(parameter.fallback) {
  const QString name = toText(parameter_.title);
  setToolTip(tip(parameter_));
  if (parameter_.kind == Kind::Choice) {
    choice_ = new Combo(name, this);
    for (const std::string& c : parameter_.choices) choice_->addItem(toText(c));
    connect(choice_, &QComboBox::activated, this, [this](int index) { Q_EMIT edited(toText(parameter_.key), index); });
  } else {
    slider_ = new Slider(this);
    slider_->setAccessibleName(name);
    number_ = new QLineEdit(this);
    number_->setAccessibleName(tr("%1, number").arg(name));
    number_->setFrame(false);
    number_->setAlignment(Qt::AlignRight);
    number_->setTextMargins(0, 0, 0, 0);
    number_->installEventFilter(this);
    connect(slider_, &QSlider::valueChanged, this, &ParameterRow::sliderMoved);
    connect(number_, &QLineEdit::editingFinished, this, &ParameterRow::numberTyped);
  }
  reset_ = new QToolButton(this);
  reset_->setText(tr("Reset"));
  reset_->setAccessibleName(tr("Reset %1 to its default").arg(name));
  reset_->setAutoRaise(true);
  reset_->setCursor(Qt::PointingHandCursor);
  QFont small = textFont(11);
  small.setUnderline(true);
  reset_->setFont(small);
  reset_->hide();
  connect(reset_, &QToolButton::clicked, this, [this] { Q_EMIT edited(toText(parameter_.key), base_); });
  setFixedHeight(kRow);
}

bool ParameterRow::logarithmic() const {
  return parameter_.sliderLow > 0 && parameter_.sliderHigh / parameter_.sliderLow >= 50;
}

double ParameterRow::valueAt(int position) const {
  const double share = static_cast<double>(position) / Slider::kSteps;
  const double low = parameter_.sliderLow, high = parameter_.sliderHigh;
  if (position == 0) return low;
  if (position == Slider::kSteps) return high;
  double value = logarithmic() ? low * std::pow(high / low, share) : low + share * (high - low);
  // Round numbers: three digits of the range, whole numbers where the parameter has no others.
  const double unit = parameter_.kind == Kind::Integer ? 1.0
                      : logarithmic()                  ? std::pow(10.0, std::floor(std::log10(value)) - 1)
                                                       : std::pow(10.0, std::floor(std::log10(high - low)) - 2);
  value = std::round(value / unit) * unit;
  return std::clamp(value, low, high);
}

int ParameterRow::sliderAt(double value) const {
  const double low = parameter_.sliderLow, high = parameter_.sliderHigh;
  const double v = std::clamp(value, low, high);
  const double share = logarithmic() ? std::log(v / low) / std::log(high / low) : (v - low) / (high - low);
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
    return text.replace(QStringLiteral("e-0"), QStringLiteral("e-")).replace('-', QChar(0x2212));
  };
  const auto fits = [&](const QString& text) {
    return !number_ || number_->fontMetrics().horizontalAdvance(text) <= kNumber - 3;
  };
  const double shown = QString::number(value, 'f', decimals).toDouble();
  const bool precise = value == 0.0 || std::abs(shown / value - 1.0) < 0.01;
  if (const QString text = written('f', decimals); precise && fits(text)) return text;
  const QString text = written('g', 3);
  return fits(text) ? text : written('e', 1);
}

void ParameterRow::show(double value, double base, std::optional<std::int64_t> changedAt) {
  if (value == base) changedAt.reset();
  // Something else may stand there now: typed, or a slider that was moved to where it must not be.
  const bool moved = number_ && (number_->isModified() || slider_->value() != sliderAt(value));
  if (shown_ && !moved && value == value_ && base == base_ && changedAt == changedAt_) return;
  shown_ = true;
  value_ = value;
  base_ = base;
  changedAt_ = changedAt;
  const bool changed = value != base;
  if (choice_) {
    const QSignalBlocker blocker(choice_);
    choice_->setCurrentIndex(static_cast<int>(value));
  } else {
    const QSignalBlocker blockSlider(slider_), blockNumber(number_);
    if (!slider_->isSliderDown()) slider_->setValue(sliderAt(value));
    const QString text = textOf(value);
    const bool typing = number_->hasFocus() && number_->isModified();
    if (!typing && number_->text() != text) number_->setText(text);
  }
  reset_->setVisible(changed);
  setFixedHeight(changed ? kRow + kChanged : kRow);
  update();
}

void ParameterRow::setInForce(bool inForce) {
  inForce_ = inForce;
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
  QString text = number_->text().trimmed();
  text.replace(QChar(0x2212), '-').replace(',', '.');
  Parameter named = parameter_;  // the form speaks of "Exploration", not of policy.epsilon
  named.key = parameter_.title;
  const Result<double> value = parseValue(named, text.toStdString());
  if (value)
    Q_EMIT edited(toText(parameter_.key), *value);
  else
    Q_EMIT refused(toText(value.error().message));
  number_->setText(textOf(value_));
}

void ParameterRow::resizeEvent(QResizeEvent*) {
  const int w = width();
  const int right = w - kUnit - 2;
  if (choice_) {
    choice_->setGeometry(w / 2, 1, w / 2, kRow - 2);
  } else {
    const int left = w / 2 - 9;
    number_->setGeometry(right - kNumber, 2, kNumber, kRow - 4);
    slider_->setGeometry(left, 0, right - kNumber - left - 1, kRow);
  }
  reset_->setGeometry(w - 36, kRow - 2, 36, kChanged);
}

// A number that is reached by Tab is selected whole, so that typing replaces it.
bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn || event->type() == QEvent::FocusOut) update();
  if (event->type() == QEvent::FocusIn) QMetaObject::invokeMethod(number_, &QLineEdit::selectAll, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void ParameterRow::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  if (number_ && number_->hasFocus()) {
    p.setPen(QPen(t.accent, 2));
    p.drawRoundedRect(number_->geometry().adjusted(-2, 0, 2, 0), 3, 3);
  }
  if (!policy_.empty()) drawMarker(p, {5, kRow / 2.0}, policyLook(policy_, t), inForce_);
  const QFont font = textFont(13);
  p.setFont(font);
  p.setPen(t.ink);
  const double end = slider_ ? slider_->x() + 4 : width() / 2 - 4;  // of the room for words
  const QString symbol = toText(parameter_.symbol);
  const QFontMetricsF metrics(font);
  QString title = toText(parameter_.label.empty() ? parameter_.title : parameter_.label);
  // "Stance knee k̇" rather than "Stance knee ra…": the symbol says what the last word did.
  if (!symbol.isEmpty() && metrics.horizontalAdvance(title) > end - kName) title = title.section(' ', 0, -2);
  title = metrics.elidedText(title, Qt::ElideRight, end - kName);
  const double baseline = kRow / 2.0 + 4.5;
  p.drawText(QPointF(kName, baseline), title);
  p.setPen(t.quiet);
  const double symbolLeft = kName + metrics.horizontalAdvance(title) + 5;
  if (symbolWidth(font, symbol) <= end - symbolLeft) drawSymbol(p, symbolLeft, baseline, symbol);
  p.setFont(textFont(11));
  QString unit = toText(parameter_.unit);
  if (QFontMetricsF(p.font()).horizontalAdvance(unit) > kUnit - 3) unit.remove(' ');
  p.drawText(QPointF(width() - kUnit + 3, baseline - 0.5), unit);
  if (value_ == base_) return;
  const QString fallback = choice_ ? toText(formatValue(parameter_, base_)) : textOf(base_);
  const QString text =
      changedAt_ ? tr("set at step %1, default %2").arg(toText(countText(static_cast<double>(*changedAt_))), fallback)
                 : tr("default %1").arg(fallback);
  p.drawText(QPointF(kName, kRow + 9), text);
}

}  // namespace surefoot
