// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/maps/value_maps.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/round_numbers.h"

namespace surefoot {

namespace {

/// The power of ten that no number of visits on the map is above; at least 10.
double highestVisits(const ValueMap& map) {
  const auto range = map.range();
  return std::pow(10.0, std::ceil(std::log10(range ? std::max(range->second, 10.0) : 10.0)));
}

}  // namespace

ValueMaps::ValueMaps(RunningLife& life, Looking& looking, QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  choice_.fit(life_.task());
  rebuildPolicy();
  connect(&life_, &RunningLife::valuesArrived, this, &ValueMaps::recompute);
  connect(&life_, &RunningLife::configurationChanged, this, [this] {
    rebuildPolicy();
    recompute();
  });
  connect(&looking_, &Looking::frame, this, &ValueMaps::followLive);
  connect(&looking_, &Looking::examinedChanged, this, [this] {
    speak();
    update();
  });
  connect(&life_, &RunningLife::replaced, this, [this] {
    any_ = false;
    rebuildPolicy();
    if (!choice_.suits(life_.task())) choice_.fit(life_.task());
    update();
  });
}

// Values come ten times per second, the world moves sixty times: the ring moves with the world.
void ValueMaps::followLive() {
  constexpr int kEvery = 30;  // [ms]
  if (!isVisible() || !any_ || looking_.shown().state == drawn_) return;
  if (sinceDrawn_.isValid() && sinceDrawn_.elapsed() < kEvery) return;
  sinceDrawn_.start();
  drawn_ = looking_.shown().state;
  update();
}

void ValueMaps::setChoice(const MapChoice& choice) {
  if (!choice.suits(life_.task())) return;  // chosen for another environment
  choice_ = choice;
  recompute();
  Q_EMIT shown();
}

bool ValueMaps::split() const {
  return life_.values() && life_.values()->values->split();
}

bool ValueMaps::risky() const {
  return life_.values() && looking_.valuesShown()->hasRisk() && !(split() && valued());
}

void ValueMaps::rebuildPolicy() {
  const Configuration& c = life_.configuration();
  if (auto policy = makePolicy(life_.registry(), c.names.policy, c.parameters)) policy_ = std::move(*policy);
}

/// The risk above which the policy in force allows no action; none: it does not look at that.
std::optional<double> ValueMaps::riskLimit() const {
  if (!policy_ || !life_.values() || !looking_.valuesShown()->hasRisk()) return std::nullopt;
  return policy_->caution().limit();
}

bool ValueMaps::valued() const {
  return choice_.quantity == MapQuantity::BestAction || choice_.quantity == MapQuantity::OneAction;
}

/// The colours of the large map.
MapScale ValueMaps::scaleOf(const ValueMap& map) const {
  const Task& task = life_.task();
  const auto range = map.range();
  switch (choice_.quantity) {
    case MapQuantity::GreedyAction:
      return {MapScale::Kind::Steps, 0, static_cast<double>(greedyValues(choice_, task)) - 1};
    case MapQuantity::Visits:
      return {MapScale::Kind::Viridis, 1, highestVisits(map)};
    case MapQuantity::Eligibility:
      return {MapScale::Kind::Positive, 0, 1};
    case MapQuantity::Risk:
      return riskScale_;
    default:
      break;
  }
  double low = task.lowestReturn, high = task.highestReturn;
  if (!choice_.locked && range) {
    // A side that is very small beside the other side gets almost no colour.
    constexpr double kLeast = 0.05;
    std::tie(low, high) = *range;
    const double least = kLeast * std::max(std::abs(low), std::abs(high));
    if (low < 0) low = std::min(low, -least);
    if (high > 0) high = std::max(high, least);
  }
  low = std::min(low, 0.0), high = std::max(high, 0.0);
  if (low == high) high = 1.0;  // nothing learned yet
  if (!choice_.locked) {        // to round numbers, the same ones whatever the size of the cells
    const double step = niceAbove(std::max(-low, high) / 10);
    low = step * std::floor(low / step + 1e-9), high = step * std::ceil(high / step - 1e-9);
  }
  return {MapScale::Kind::Diverging, low, high};
}

/// Where an action leads in a picture, by its name, right and down positive; empty: actions are no directions.
std::vector<QPointF> ValueMaps::directions() const {
  static const std::map<std::string, QPointF> kDirections = {
      {"up", {0, -1}}, {"down", {0, 1}}, {"left", {-1, 0}}, {"right", {1, 0}}};
  std::vector<QPointF> list;
  for (const std::string& name : life_.task().actionNames) {
    const auto found = kDirections.find(name);
    if (found == kDirections.end()) return {};
    list.push_back(found->second);
  }
  return list;
}

// Colours of a paused life change with the theme, too.
void ValueMaps::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) recompute();
}

void ValueMaps::recompute() {
  const ValueSnapshot* v = life_.values();
  const Task& task = life_.task();
  if (!isVisible() || !v || task.state.empty() || looking_.shown().state.size() != task.state.size()) return;
  const bool dark = themeOf(*this).dark;
  const Geometry g = geometry();
  slice_ = choice_.slice(looking_.shown().state);
  if (choice_.quantity == MapQuantity::Risk && !looking_.valuesShown()->hasRisk())
    choice_.quantity = MapQuantity::BestAction;
  if (policy_) policy_->advance(life_.lifeTime());
  const auto chosen = choice_.quantity == MapQuantity::Visits        ? visits()
                      : choice_.quantity == MapQuantity::Eligibility ? eligibility()
                      : choice_.quantity == MapQuantity::Risk        ? risk()
                                                                     : quantity(Layer::Sum);
  big_.evaluate(task, slice_, static_cast<int>(g.square.width()) / kCell, choice_.projected(task, chosen));
  if (!directions().empty()) best_.evaluate(task, slice_, static_cast<int>(g.square.width()) / kCell, bestActions());
  risk_ = {};
  if (riskLimit() && valued())
    risk_.evaluate(task, slice_, static_cast<int>(g.square.width()) / kCell, choice_.projected(task, risk()));
  bigScale_ = scaleOf(big_);
  big_.colour(bigScale_, dark);
  computeSmall(std::max(static_cast<int>(g.upper.width()) / kSmallCell, 1), dark);
  any_ = true;
  speak();
  Q_EMIT shown();
  update();
}

void ValueMaps::computeSmall(int cells, bool dark) {
  const Task& task = life_.task();
  if (split() && valued()) {
    upper_.evaluate(task, slice_, cells, choice_.projected(task, partOf(Layer::Positive)));
    lower_.evaluate(task, slice_, cells, choice_.projected(task, partOf(Layer::Negative)));
    upper_.colour(bigScale_, dark);
    lower_.colour(bigScale_, dark);
    return;
  }
  if (risky()) {
    upper_.evaluate(task, slice_, cells, choice_.projected(task, risk()));
    lower_.evaluate(task, slice_, cells, choice_.projected(task, visits()));
    visitScale_.high = highestVisits(lower_);
    upper_.colour(riskScale_, dark);
    lower_.colour(visitScale_, dark);
    return;
  }
  upper_.evaluate(task, slice_, cells, choice_.projected(task, visits()));
  lower_.evaluate(task, slice_, cells, choice_.projected(task, eligibility()));
  visitScale_.high = highestVisits(upper_);
  upper_.colour(visitScale_, dark);
  lower_.colour(eligibilityScale_, dark);
}

std::string ValueMaps::asCsv() const {
  return big_.empty() ? "" : big_.asCsv(life_.task(), quantityText(choice_, life_.task()).toStdString());
}

std::optional<std::vector<double>> ValueMaps::stateAt(const QPointF& at) const {
  if (!any_) return std::nullopt;
  const Geometry g = geometry();
  for (const auto& [map, square] : {std::pair{&big_, g.big}, {&upper_, g.upper}, {&lower_, g.lower}})
    if (auto state = map->stateAt(life_.task(), at, square)) return state;
  return std::nullopt;
}

void ValueMaps::mouseMoveEvent(QMouseEvent* event) {
  const auto state = stateAt(mouseAt(*event));
  setCursor(state ? Qt::CrossCursor : Qt::ArrowCursor);
  looking_.examine(state);
}

void ValueMaps::mousePressEvent(QMouseEvent* event) {
  const auto state = stateAt(mouseAt(*event));
  if (!state || event->button() != Qt::LeftButton) return;
  if (event->modifiers() & Qt::ShiftModifier)
    looking_.pin(state);
  else
    Q_EMIT placeAsked(*state);
}

void ValueMaps::leaveEvent(QEvent*) {
  looking_.examine(std::nullopt);
}

void ValueMaps::focusOutEvent(QFocusEvent* event) {
  looking_.examine(std::nullopt);
  QWidget::focusOutEvent(event);
}

}  // namespace surefoot

#include "moc_value_maps.cpp"
