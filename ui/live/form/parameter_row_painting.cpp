// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a row are, how it is drawn, and how its number is dragged.
#include <QEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/controls/combo.h"
#include "ui/controls/slider.h"
#include "ui/language/from_core.h"
#include "ui/live/form/parameter_row.h"
#include "ui/style/icons.h"
#include "ui/style/policy_look.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {

constexpr int kRow = 24, kName = 20, kUnit = 28, kBeforeMiddle = 12, kReset = 18;  // [px]

/// An arrow that turns back.
class ResetButton final : public Painted<QToolButton> {
 public:
  using Painted::Painted;

 protected:
  void paintEvent(QPaintEvent*) override {
    const Theme& t = themeOf(*this);
    ScaledPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    if (hasFocus()) {
      p.setPen(QPen(t.accent, 2));
      p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 3, 3);
    }
    p.translate(width() / 2.0 - 1, height() / 2.0 + 1);
    p.scale(-0.8, 0.8);
    drawIcon(p, Icon::Restart, QRectF(-8, -8, 16, 16), underMouse() ? t.ink : t.quiet);
  }
};

}  // namespace

void ParameterRow::makeReset(const QString& name) {
  reset_ = new ResetButton(this);
  reset_->setAccessibleName(tr("Reset %1 to its default").arg(name));
  reset_->setCursor(Qt::PointingHandCursor);
  reset_->hide();
  connect(reset_, &QToolButton::clicked, this, [this] { Q_EMIT edited(toText(parameter_.key), base_); });
}

void ParameterRow::layOut() {
  const int w = width();
  setFixedHeight(scaled(kRow));
  const double unitWidth = symbolWidth(textFont(11), toText(parameter_.unit)) + 4;
  const int unit = std::max(kUnit, static_cast<int>(std::ceil(unitWidth)));
  const int right = w - unit - 2;
  // Reset stands in the marker's place. A policy's parameter has a marker but no unit: there it takes the unit's place.
  place(*reset_, {policy_.empty() ? 0 : w - kReset - 1, (kRow - kReset) / 2, kReset, kReset});
  if (choice_) {
    place(*choice_, {w / 2, 1, w - w / 2 - (policy_.empty() ? 0 : kReset + 2), kRow - 2});
    return;
  }
  const int left = w / 2 - kBeforeMiddle;
  place(*number_, {right - kNumberRoom, 2, kNumberRoom, kRow - 4});
  place(*slider_, {left, 0, right - kNumberRoom - left - 1, kRow});
}

void ParameterRow::resizeEvent(QResizeEvent*) {
  layOut();
}

// A number that is reached by Tab is selected whole, so that typing replaces it.
bool ParameterRow::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (type == QEvent::FocusIn || type == QEvent::FocusOut) {
    number_->setCursor(type == QEvent::FocusIn ? Qt::IBeamCursor : Qt::SizeHorCursor);
    update();
  }
  if (type == QEvent::FocusIn) QMetaObject::invokeMethod(number_, &QLineEdit::selectAll, Qt::QueuedConnection);
  if (type == QEvent::MouseButtonPress || type == QEvent::MouseMove || type == QEvent::MouseButtonRelease)
    if (dragged(static_cast<QMouseEvent*>(event))) return true;
  return QWidget::eventFilter(watched, event);
}

// A press on a number that is not being edited begins a drag: kRange pixels are the whole range; with Shift, a tenth of
// it. A press without a move is a click, and edits.
bool ParameterRow::dragged(QMouseEvent* event) {
  constexpr double kRange = 250, kClick = 3;  // [px]
  const double x = event->globalPosition().x();
  if (event->type() == QEvent::MouseButtonPress) {
    if (number_->hasFocus() || event->button() != Qt::LeftButton) return false;
    pressedAt_ = x;
    dragFrom_ = slider_->value();
    dragging_ = false;
    return true;
  }
  if (!pressedAt_) return false;
  if (event->type() == QEvent::MouseButtonRelease) {
    pressedAt_.reset();
    if (!dragging_) number_->setFocus(Qt::MouseFocusReason);
    return true;
  }
  dragging_ |= std::abs(x - *pressedAt_) > kClick;
  if (!dragging_) return true;
  const double fine = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1.0;
  const double to = dragFrom_ + fine * (x - *pressedAt_) * Slider::kSteps / kRange;
  slider_->setValue(static_cast<int>(std::lround(std::clamp<double>(to, 0, Slider::kSteps))));
  return true;
}

void ParameterRow::paintName(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const double end = slider_ ? placeOf(*slider_).x() + 2 : placeOf(*choice_).x() - 4;  // room for words ends
  const double left = kName, room = end - left;
  const QString symbol = toText(parameter_.symbol);
  QFont font = textFont(13);
  QString title = fromCore(parameter_.label.empty() ? parameter_.title : parameter_.label);
  const auto width = [&] { return QFontMetricsF(font).horizontalAdvance(title); };
  // "Stance knee k̇" rather than "Stance knee ra…": the symbol stands for the last word.
  if (!symbol.isEmpty() && width() > room && title.contains(' ')) title = title.section(' ', 0, -2);
  const double beside = symbol.isEmpty() ? 0 : 5 + symbolWidth(textFont(13), symbol);
  if (width() + beside > room) font = textFont(11);
  title = QFontMetricsF(font).elidedText(title, Qt::ElideRight, room);
  const double baseline = height() / 2.0 + QFontMetricsF(textFont(13)).capHeight() / 2.0;
  p.setFont(font);
  p.setPen(t.ink);
  p.drawText(QPointF(left, baseline), title);
  p.setFont(textFont(13));
  p.setPen(t.quiet);
  const double symbolLeft = left + width() + 5;
  if (symbolWidth(p.font(), symbol) <= end - symbolLeft) drawSymbol(p, symbolLeft, baseline, symbol);
}

/// A sign and a few words, in place of name and slider.
void ParameterRow::paintRefusal(QPainter& p) const {
  const Theme& t = themeOf(*this);
  const double side = 12, left = kName, middle = height() / 2.0;
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(t.caution, 1.5));
  p.setBrush(Qt::NoBrush);
  const double top = middle - side / 2, foot = middle + side / 2;
  p.drawPolygon(QPolygonF({{left, foot}, {left + side / 2, top}, {left + side, foot}}));
  p.drawLine(QPointF(left + side / 2, middle - side / 6), QPointF(left + side / 2, middle + side / 6));
  p.drawPoint(QPointF(left + side / 2, middle + side / 3));
  const double begin = left + side + 5, end = (number_ ? placeOf(*number_) : placeOf(*choice_)).x() - 4;
  p.setFont(textFont(11));
  const QString words = QFontMetricsF(p.font()).elidedText(refusal_, Qt::ElideRight, end - begin);
  p.drawText(QRectF(begin, 0, end - begin, height()), Qt::AlignLeft | Qt::AlignVCenter, words);
  if (number_) p.drawRoundedRect(placeOf(*number_).adjusted(-2, -0.5, 2, 0.5), 3, 3);
}

void ParameterRow::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  if (!policy_.empty())
    drawMarker(p, {5, height() / 2.0}, policyLook(inForce_.empty() ? policy_ : inForce_, t), !inForce_.empty());
  refusal_.isEmpty() ? paintName(p) : paintRefusal(p);
  if (number_ && number_->hasFocus()) {
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(t.accent, 2));
    p.drawRoundedRect(placeOf(*number_).adjusted(-2, 0, 2, 0), 3, 3);
  }
  p.setFont(textFont(11));
  p.setPen(t.quiet);
  if (!number_) return;
  const double baseline = height() / 2.0 + QFontMetricsF(p.font()).capHeight() / 2.0;
  p.drawText(QPointF(placeOf(*number_).right() + 5, baseline), toText(parameter_.unit));
}

}  // namespace surefoot
