// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/strip_charts.h"

#include <fmt/format.h>

#include <QKeyEvent>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/keyboard.h"

namespace surefoot {

namespace {
constexpr double kZoom = 1.25;
constexpr int kSayEvery = 500;  // [ms]
}  // namespace

StripCharts::StripCharts(SignalsShown& shown, QWidget* parent) : Painted(parent), shown_(shown) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Signals"));
  sinceSaid_.start();
  shown_.watchedBy(*this);
  connect(&shown_, &SignalsShown::changed, this, [this] {
    updateGeometry();
    update();
  });
  connect(&shown_, &SignalsShown::moment, this, [this] {
    if (sinceSaid_.elapsed() > kSayEvery) say();
    update();
  });
}

/// These keys are the charts' before they are the window's shortcuts.
bool StripCharts::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    constexpr int kOwn[] = {Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_Home, Qt::Key_PageUp, Qt::Key_PageDown};
    const auto& key = *static_cast<QKeyEvent*>(event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    if (plain && std::find(std::begin(kOwn), std::end(kOwn), key.key()) != std::end(kOwn)) {
      event->accept();
      return true;
    }
  }
  return Painted::event(event);
}

QSize StripCharts::minimumSizeHint() const {
  const double height = shown_.table().signals().empty() ? 200.0 : StripPainter::leastHeight(picture());
  return scaled(QSize{420, static_cast<int>(std::ceil(height))});
}

StripPicture StripCharts::picture() const {
  const auto [first, second] = shown_.names();
  return {.table = &shown_.table(),
          .second = shown_.second().rows() > 0 ? &shown_.second() : nullptr,
          .secondLater = shown_.secondLater(),
          .names = {first, second},
          .strips = shown_.strips(),
          .from = shown_.from(),
          .to = shown_.to(),
          .row = shown_.row(),
          .band = shown_.band(),
          .learner = shown_.learnerColour(themeOf(*this)),
          .clock = shown_.hasClock()};
}

bool StripCharts::showsStrips() const {
  return shown_.table().rows() > 0 && !shown_.strips().empty();
}

void StripCharts::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  ScaledPainter p(this);
  p.fillRect(rect(), t.panel);
  if (!showsStrips()) {
    p.setFont(textFont(11));
    p.setPen(t.quiet);
    p.drawText(rect().adjusted(12, 0, -12, 0), Qt::AlignCenter | Qt::TextWordWrap,
               shown_.strips().empty() && shown_.table().rows() > 0
                   ? tr("No signal is chosen.")
                   : tr("Signals appear here while the world goes on, in a replay of a fall, and in a roll-out."));
    plot_ = {};
    return;
  }
  const StripPicture what = picture();
  const StripPainter painter(t, what, rect());
  painter.paint(p);
  plot_ = painter.plot();
  places_ = painter.strips();
  from_ = what.from, to_ = what.to;
  if (dragged_) {
    const auto target = targetAt(dragY_);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(t.accent, 2));
    if (target && target->onto)
      p.drawRect(places_[target->strip].adjusted(4, 0, -4, 0));
    else if (target) {
      const double y = target->strip < places_.size() ? places_[target->strip].top() - 4 : places_.back().bottom() + 4;
      p.drawLine(QPointF(4, y), QPointF(width() - 4, y));
    }
  }
  if (hasFocus()) drawFocusRing(p, *this);
}

std::optional<std::size_t> StripCharts::stripAt(const QPointF& at) const {
  const double shownDownTo = visibleRegion().boundingRect().bottom() / textSize();  // the time axis lies over the rest
  if (at.y() > shownDownTo - StripPainter::kTimes) return std::nullopt;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (at.y() >= places_[i].top() - 4 && at.y() < places_[i].bottom() + 4) return i;
  return std::nullopt;
}

std::optional<StripCharts::Target> StripCharts::targetAt(double y) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double share = (y - places_[i].top()) / places_[i].height();
    if (share < 0.3) return Target{i, false};
    if (share < 0.7) return i == dragged_ ? std::nullopt : std::optional(Target{i, true});
  }
  return places_.empty() ? std::nullopt : std::optional(Target{places_.size(), false});
}

void StripCharts::drop(std::size_t strip, const Target& target) {
  std::vector<Strip> strips = shown_.strips();
  if (strip >= strips.size()) return;
  Strip moved = strips[strip];
  if (target.onto) {
    Strip& onto = strips[target.strip];
    onto.insert(onto.end(), moved.begin(), moved.end());
    strips.erase(strips.begin() + static_cast<std::ptrdiff_t>(strip));
  } else {
    const std::size_t to = target.strip > strip ? target.strip - 1 : target.strip;
    strips.erase(strips.begin() + static_cast<std::ptrdiff_t>(strip));
    strips.insert(strips.begin() + static_cast<std::ptrdiff_t>(std::min(to, strips.size())), std::move(moved));
  }
  shown_.setStrips(std::move(strips));
}

void StripCharts::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || plot_.isEmpty()) return Painted::mousePressEvent(event);
  const QPointF at = mouseAt(*event);
  if (at.x() < plot_.left() - 40) {
    dragged_ = stripAt(at);
    dragY_ = at.y();
  } else if (at.x() <= plot_.right() + 6) {
    seeking_ = true;
    mouseMoveEvent(event);
  }
}

void StripCharts::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = mouseAt(*event);
  if (seeking_) shown_.seek(from_ + (at.x() - plot_.left()) / plot_.width() * (to_ - from_));
  if (dragged_) dragY_ = at.y();
  update();
}

void StripCharts::mouseReleaseEvent(QMouseEvent*) {
  seeking_ = false;
  const auto strip = dragged_;
  const auto target = targetAt(dragY_);
  dragged_.reset();
  if (strip && target) drop(*strip, *target);
  update();
}

void StripCharts::mouseDoubleClickEvent(QMouseEvent*) {
  shown_.showAll();
}

void StripCharts::wheelEvent(QWheelEvent* event) {
  if (plot_.isEmpty() || (event->modifiers() & Qt::ControlModifier)) return event->ignore();
  const QPoint turned = event->angleDelta();
  if (event->modifiers() & Qt::ShiftModifier || std::abs(turned.x()) > std::abs(turned.y())) {
    const int way = turned.x() != 0 ? turned.x() : turned.y();
    return shown_.shift(-way / 1200.0);
  }
  const double time = from_ + (mouseAt(*event).x() - plot_.left()) / plot_.width() * (to_ - from_);
  shown_.magnify(turned.y() > 0 ? 1 / kZoom : kZoom, std::clamp(time, from_, to_));
}

void StripCharts::keyPressEvent(QKeyEvent* event) {
  const auto row = shown_.row();
  const double around = row && *row < shown_.table().rows() ? shown_.table().columns()[0][*row] : 0.5 * (from_ + to_);
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return shown_.magnify(1 / kZoom, std::clamp(around, from_, to_));
    case Qt::Key_Minus:
      return shown_.magnify(kZoom, std::clamp(around, from_, to_));
    case Qt::Key_Home:
      return shown_.showAll();
    case Qt::Key_PageUp:
      return shown_.shift(-0.5);
    case Qt::Key_PageDown:
      return shown_.shift(0.5);
    default:
      return Painted::keyPressEvent(event);
  }
}

void StripCharts::say() {
  sinceSaid_.restart();
  const auto row = shown_.row();
  if (!row || *row >= shown_.table().rows()) return;
  const auto& signals = shown_.table().signals();
  QStringList all;
  for (const Strip& strip : shown_.strips())
    for (const std::size_t at : signalsIn(strip, signals).places) {
      const double value = shown_.table().columns()[at][*row];
      if (!std::isnan(value))
        all << tr("%1 %2 %3").arg(fromCore(signals[at].title), fixedNumber(value, 2), toText(signals[at].unit));
    }
  setAccessibleDescription(
      tr("At %1 seconds: %2.").arg(fixedNumber(shown_.table().columns()[0][*row], 2), all.join(QStringLiteral("; "))));
}

void StripCharts::fillMenu(QMenu& menu) {
  connect(menu.addAction(tr("The whole time")), &QAction::triggered, this, [this] { shown_.showAll(); });
  connect(menu.addAction(tr("The usual signals")), &QAction::triggered, this, [this] { shown_.setUsualStrips(); });
}

std::string StripCharts::asCsv() const {
  const SignalTable &table = shown_.table(), &second = shown_.second();
  if (table.rows() == 0) return {};
  const auto& signals = table.signals();
  std::vector<std::size_t> places;
  for (const Strip& strip : shown_.strips())
    for (const std::size_t at : signalsIn(strip, signals).places) places.push_back(at);
  std::string csv = "time";
  for (const std::size_t at : places) csv += "," + signals[at].key;
  if (second.rows() > 0)
    for (const std::size_t at : places) csv += ",second_" + signals[at].key;
  csv += '\n';
  const auto add = [&](const SignalTable& of, std::optional<std::size_t> row, std::size_t at) {
    const auto* column = columnLike(of, table, at);
    const double value = row && column ? (*column)[*row] : std::nan("");
    csv += std::isnan(value) ? "," : fmt::format(",{}", value);
  };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double time = table.columns()[0][row];
    if (time < shown_.from() - 1e-9 || time > shown_.to() + 1e-9) continue;
    csv += fmt::format("{}", time);
    for (const std::size_t at : places) add(table, row, at);
    if (second.rows() > 0)
      for (const std::size_t at : places) add(second, rowAt(second, time - shown_.secondLater()), at);
    csv += '\n';
  }
  return csv;
}

}  // namespace surefoot

#include "moc_strip_charts.cpp"
