// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/scale.h"

#include <QApplication>
#include <QLayout>
#include <QPointer>
#include <QResizeEvent>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ui/style/theme.h"

namespace surefoot {

namespace {

double theScale = 1.0;

struct Follower {
  QPointer<QObject> owner;
  std::function<void()> apply;
};

std::vector<Follower>& followers() {
  static std::vector<Follower> list;
  return list;
}

/// Styles and layouts keep old sizes: this makes both ask again. A widget that is laid out by hand does it in its
/// resizeEvent.
void measureAgain(const QPointer<QWidget>& widget) {
  if (!widget) return;
  QEvent style(QEvent::StyleChange);
  QApplication::sendEvent(widget, &style);
  if (!widget) return;
  widget->updateGeometry();
  const QSize size = widget->size();
  QResizeEvent resized(size, size);
  if (widget->testAttribute(Qt::WA_WState_Created) || widget->isVisible()) QApplication::sendEvent(widget, &resized);
  if (widget) widget->update();
}

/// Lays out once more after all widgets were measured: a menu bar is as high as the widget in its corner.
void layOutAgain(const std::vector<QPointer<QWidget>>& widgets) {
  for (const QPointer<QWidget>& widget : widgets) {
    if (!widget || !widget->layout()) continue;
    widget->layout()->invalidate();
    QApplication::postEvent(widget, new QEvent(QEvent::LayoutRequest));
  }
}

/// Visible widgets are measured at once. Hidden ones (other pages, closed dialogs) are measured in parts, between other
/// events, so that nobody waits for them.
class Measuring final {
 public:
  Measuring() {
    next_.setSingleShot(true);
    QObject::connect(&next_, &QTimer::timeout, [this] { goOn(); });
  }
  void begin() {
    shown_.clear(), hidden_.clear();
    for (QWidget* widget : QApplication::allWidgets()) (widget->isVisible() ? shown_ : hidden_).emplace_back(widget);
    for (const QPointer<QWidget>& widget : shown_) measureAgain(widget);
    at_ = 0;
    next_.start();
  }

 private:
  void goOn() {
    constexpr std::size_t kAtOnce = 64;
    layOutAgain(std::exchange(shown_, {}));
    for (std::size_t i = 0; i < kAtOnce && at_ < hidden_.size(); ++i) measureAgain(hidden_[at_++]);
    if (at_ < hidden_.size()) return next_.start();
    layOutAgain(std::exchange(hidden_, {}));
  }

  QTimer next_;
  std::vector<QPointer<QWidget>> shown_, hidden_;
  std::size_t at_ = 0;  // index in hidden_
};

}  // namespace

double textSize() {
  return theScale;
}

void applyTextSize(double scale) {
  const double next = std::clamp(std::round(scale / kTextStep) * kTextStep, kSmallestText, kLargestText);
  if (!(std::abs(next - theScale) > 1e-9)) return;
  theScale = next;
  QApplication::setFont(scaledFont(13));
  std::erase_if(followers(), [](const Follower& f) { return !f.owner; });
  for (std::size_t i = 0; i < followers().size(); ++i)
    if (const Follower f = followers()[i]; f.owner) f.apply();
  static Measuring measuring;
  measuring.begin();
}

int scaled(int pixels) {
  const int length = static_cast<int>(std::lround(pixels * theScale));
  return pixels > 0 ? std::max(1, length) : length;
}

double scaled(double pixels) {
  return pixels * theScale;
}

QSize scaled(QSize pixels) {
  return {scaled(pixels.width()), scaled(pixels.height())};
}

QMargins scaled(QMargins m) {
  return {scaled(m.left()), scaled(m.top()), scaled(m.right()), scaled(m.bottom())};
}

QFont scaledFont(int pixels, int weight) {
  return textFont(scaled(pixels), weight);
}

void whenScaled(QObject* owner, const std::function<void()>& apply) {
  followers().push_back({owner, apply});
  apply();
}

}  // namespace surefoot
