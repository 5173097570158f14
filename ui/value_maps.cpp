// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/value_maps.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.h"
#include "ui/session.h"
#include "ui/symbol_text.h"

namespace surefoot {

namespace {
constexpr double kFamiliar = 0.25;  // share of the active tiles below which a state counts as never visited
constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
}  // namespace

ValueMaps::ValueMaps(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  choice_.fit(session_.task());
  connect(&session_, &Session::valuesArrived, this, &ValueMaps::recompute);
  connect(&session_, &Session::examinedChanged, this, [this] {
    speak();
    update();
  });
  connect(&session_, &Session::lifeReplaced, this, [this] {
    any_ = false;
    if (!choice_.suits(session_.task())) choice_.fit(session_.task());
    update();
  });
}

void ValueMaps::setChoice(const MapChoice& choice) {
  if (!choice.suits(session_.task())) return;  // chosen for another environment
  choice_ = choice;
  recompute();
  Q_EMIT shown();
}

bool ValueMaps::split() const {
  return session_.values() && session_.values()->values->split();
}

bool ValueMaps::valued() const {
  return choice_.quantity == MapQuantity::BestAction || choice_.quantity == MapQuantity::OneAction;
}

/// q̂ of the best action or of the chosen one, or the number of the greedy action.
ValueMap::Quantity ValueMaps::quantity(Layer layer) const {
  const ActionValueFunction& values = *session_.valuesShown();
  return [this, layer, &values,
          q = std::vector<double>(static_cast<std::size_t>(values.actions()))](std::span<const double> s) mutable {
    if (values.familiarity(s) < kFamiliar) return kNever;
    values.evaluate(s, layer, q);
    if (choice_.quantity == MapQuantity::OneAction) return q[static_cast<std::size_t>(choice_.action)];
    const auto best = std::max_element(q.begin(), q.end());
    if (choice_.quantity != MapQuantity::GreedyAction) return *best;
    const auto action = static_cast<std::size_t>(best - q.begin());
    const Task& task = session_.task();
    return static_cast<double>(
        task.actionVariables.empty() ? action : levelOf(task, action, static_cast<std::size_t>(choice_.action)));
  };
}

// Both parts of the action that is best by their sum, so that the large map is the sum of the small ones.
ValueMap::Quantity ValueMaps::partOf(Layer layer) const {
  if (choice_.quantity == MapQuantity::OneAction) return quantity(layer);
  const ActionValueFunction& values = *session_.valuesShown();
  const auto n = static_cast<std::size_t>(values.actions());
  return
      [layer, &values, q = std::vector<double>(n), part = std::vector<double>(n)](std::span<const double> s) mutable {
        if (values.familiarity(s) < kFamiliar) return kNever;
        values.evaluate(s, Layer::Sum, q);
        values.evaluate(s, layer, part);
        return part[static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin())];
      };
}

ValueMap::Quantity ValueMaps::visits() const {
  const ActionValueFunction& values = *session_.valuesShown();
  return [&values](std::span<const double> s) { return values.familiarity(s) < kFamiliar ? kNever : values.visits(s); };
}

ValueMap::Quantity ValueMaps::eligibility() const {
  const ValueSnapshot& v = *session_.values();
  return
      [&v, z = std::vector<double>(static_cast<std::size_t>(v.values->actions()))](std::span<const double> s) mutable {
        if (v.values->familiarity(s) < kFamiliar) return kNever;
        v.values->average(v.eligibility, s, z);
        return *std::max_element(z.begin(), z.end());
      };
}

/// The colours of the large map.
MapScale ValueMaps::scaleOf(const ValueMap& map) const {
  const Task& task = session_.task();
  const auto range = map.range();
  switch (choice_.quantity) {
    case MapQuantity::GreedyAction:
      return {MapScale::Kind::Steps, 0, static_cast<double>(greedyValues(choice_, task)) - 1};
    case MapQuantity::Visits:
      return {MapScale::Kind::Viridis, 1,
              std::pow(10.0, std::ceil(std::log10(range ? std::max(range->second, 10.0) : 10)))};
    case MapQuantity::Eligibility:
      return {MapScale::Kind::Positive, 0, 1};
    default:
      break;
  }
  if (choice_.locked || !range)
    return {MapScale::Kind::Diverging, std::min(task.lowestReturn, -1.0), std::max(task.highestReturn, 1.0)};
  return {MapScale::Kind::Diverging, std::min(range->first, -1e-3), std::max(range->second, 1e-3)};
}

void ValueMaps::recompute() {
  const ValueSnapshot* v = session_.values();
  const Task& task = session_.task();
  if (!isVisible() || !v || task.state.size() < 2 || session_.shown().state.size() != task.state.size()) return;
  const bool dark = themeOf(*this).dark;
  const Geometry g = geometry();
  slice_ = choice_.slice(session_.shown().state);
  const auto chosen = choice_.quantity == MapQuantity::Visits        ? visits()
                      : choice_.quantity == MapQuantity::Eligibility ? eligibility()
                                                                     : quantity(Layer::Sum);
  big_.evaluate(task, slice_, static_cast<int>(g.big.width()) / kCell, choice_.projected(task, chosen));
  bigScale_ = scaleOf(big_);
  big_.colour(bigScale_, dark);
  computeSmall(static_cast<int>(g.upper.width()) / kSmallCell, dark);
  any_ = true;
  speak();
  Q_EMIT shown();
  update();
}

void ValueMaps::computeSmall(int cells, bool dark) {
  const Task& task = session_.task();
  if (split() && valued()) {
    upper_.evaluate(task, slice_, cells, choice_.projected(task, partOf(Layer::Positive)));
    lower_.evaluate(task, slice_, cells, choice_.projected(task, partOf(Layer::Negative)));
    upper_.colour(bigScale_, dark);
    lower_.colour(bigScale_, dark);
    return;
  }
  upper_.evaluate(task, slice_, cells, choice_.projected(task, visits()));
  lower_.evaluate(task, slice_, cells, choice_.projected(task, eligibility()));
  const auto range = upper_.range();
  visitScale_.high = std::pow(10.0, std::ceil(std::log10(range ? std::max(range->second, 10.0) : 10.0)));
  upper_.colour(visitScale_, dark);
  lower_.colour(eligibilityScale_, dark);
}

std::string ValueMaps::asCsv() const {
  return big_.empty() ? "" : big_.asCsv(session_.task(), quantityText(choice_, session_.task()).toStdString());
}

std::optional<std::vector<double>> ValueMaps::stateAt(const QPointF& at) const {
  if (!any_) return std::nullopt;
  const Geometry g = geometry();
  for (const auto& [map, square] : {std::pair{&big_, g.big}, {&upper_, g.upper}, {&lower_, g.lower}})
    if (auto state = map->stateAt(session_.task(), at, square)) return state;
  return std::nullopt;
}

void ValueMaps::mouseMoveEvent(QMouseEvent* event) {
  const auto state = stateAt(event->position());
  setCursor(state ? Qt::CrossCursor : Qt::ArrowCursor);
  session_.examine(state);
}

void ValueMaps::mousePressEvent(QMouseEvent* event) {
  const auto state = stateAt(event->position());
  if (!state || event->button() != Qt::LeftButton) return;
  if (event->modifiers() & Qt::ShiftModifier)
    session_.pin(state);
  else
    Q_EMIT placeAsked(*state);
}

void ValueMaps::leaveEvent(QEvent*) {
  session_.examine(std::nullopt);
}

void ValueMaps::focusOutEvent(QFocusEvent* event) {
  session_.examine(std::nullopt);
  QWidget::focusOutEvent(event);
}

// The arrows are the program's shortcuts; with the focus on the map they are the cursor's.
bool ValueMaps::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down ||
        (key == Qt::Key_Escape && !session_.examined().empty())) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void ValueMaps::moveCursor(int columns, int rows) {
  if (!any_) return;
  const QRectF unit(0, 0, 1, 1);
  const double cell = 1.0 / big_.cells();
  const auto& from = session_.examined().empty() ? session_.shown().state : session_.examined();
  QPointF at = big_.toPixel(session_.task(), from, unit) + QPointF(columns * cell, rows * cell);
  at = {std::clamp(at.x(), cell / 2, 1 - cell / 2), std::clamp(at.y(), cell / 2, 1 - cell / 2)};
  session_.examine(big_.stateAt(session_.task(), at, unit));
}

void ValueMaps::keyPressEvent(QKeyEvent* event) {
  const int far = event->modifiers() & Qt::ShiftModifier ? 5 : 1;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveCursor(-far, 0);
    case Qt::Key_Right:
      return moveCursor(far, 0);
    case Qt::Key_Up:
      return moveCursor(0, -far);
    case Qt::Key_Down:
      return moveCursor(0, far);
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (session_.examined().empty()) return;
      if (event->modifiers() & Qt::ControlModifier) return Q_EMIT placeAsked(session_.examined());
      return session_.pin(session_.examined());
    case Qt::Key_Escape:
      session_.examine(std::nullopt);
      return session_.pin(std::nullopt);
    default:
      QWidget::keyPressEvent(event);
  }
}

QString ValueMaps::spoken() const {
  const std::vector<double>& state = session_.examined();
  const ValueSnapshot* v = session_.values();
  const Task& task = session_.task();
  if (state.size() != task.state.size() || !v) return {};
  QStringList words;
  for (std::size_t d = 0; d < state.size(); ++d)
    words << QStringLiteral("%1 %2").arg(symbolOf(task.state[d]), toText(fixedText(state[d], 2)));
  if (session_.valuesShown()->familiarity(state) < kFamiliar)
    return words.join(QStringLiteral("  ")) + tr(", never visited");
  std::vector<double> q(static_cast<std::size_t>(v->values->actions()));
  session_.valuesShown()->evaluate(state, Layer::Sum, q);
  const auto best = static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin());
  return tr("%1:  Q %2 for %3,  %4 visits")
      .arg(words.join(QStringLiteral("  ")), toText(fixedText(q[best], 1)), actionNameOf(task, best),
           toText(countText(session_.valuesShown()->visits(state))));
}

void ValueMaps::speak() {
  const QString text = spoken();
  if (text == accessibleDescription()) return;
  setAccessibleDescription(text);
  QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&changed);
}

}  // namespace surefoot
