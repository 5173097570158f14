// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/actions/action_rows.h"

#include <fmt/format.h>

#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/live/maps/map_choice.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"

namespace surefoot {

namespace {
constexpr int kUpdateEvery = 200;  // [ms]: numbers that change faster cannot be read; bars change together with them
}  // namespace

ActionRows::ActionRows(RunningLife& life, Looking& looking, Editing& editing, QWidget* parent)
    : Painted(parent),
      life_(life),
      looking_(looking),
      editing_(editing) {
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  rebuild();
  sinceUpdate_.start();
  connect(&looking_, &Looking::frame, this, &ActionRows::nextFrame);
  connect(&life_, &RunningLife::valuesArrived, this, qOverload<>(&ActionRows::update));  // the threshold, as the maps
  connect(&life_, &RunningLife::configurationChanged, this, &ActionRows::rebuild);
  connect(&life_, &RunningLife::replaced, this, [this] {
    share_ = 0;
    dragging_ = false;
    rebuild();
  });
  connect(&looking_, &Looking::examinedChanged, this, [this] {
    sinceUpdate_.invalidate();
    nextFrame();
  });
}

void ActionRows::setPolicies(std::set<std::string> policies) {
  policies_ = std::move(policies);
  rebuild();
}

void ActionRows::rebuild() {
  columns_.clear();
  std::vector<std::string> names;
  for (const auto& entry : life_.registry().policies)
    if (entry.name != "greedy" && entry.name != "mellowmax" && (policies_.empty() || policies_.contains(entry.name)))
      names.push_back(entry.name);  // the others show which action is greedy, and what a Softmax is
  if (const std::string& now = life_.configuration().names.policy;
      std::find(names.begin(), names.end(), now) == names.end())
    names.insert(names.begin(), now);
  for (const std::string& name : names) {
    auto policy = makePolicy(life_.registry(), name, life_.configuration().parameters);
    if (!policy) continue;
    const auto entry = findEntry(life_.registry().policies, "policy", name);
    columns_.push_back({name, fromCore((*entry)->title), std::move(*policy), {}, {}});
  }
  q_.clear();
  positive_.clear();
  negative_.clear();
  risk_.clear();
  fitScale();
  numberWidth_ = 0;
  nextFrame();
}

bool ActionRows::inForce(std::size_t column) const {
  return columns_[column].name == life_.configuration().names.policy;
}

void ActionRows::nextFrame() {
  const Playback* playback = looking_.playback();
  const int rest = (playback ? playback->rate > 0 : life_.running()) ? kUpdateEvery : kUpdateEvery / 4;
  if (!isVisible() || (sinceUpdate_.isValid() && sinceUpdate_.elapsed() < rest && !q_.empty())) return;
  sinceUpdate_.start();
  if (looking_.shown().q.empty()) return;
  takeValues();
  fitScale();
  const LifeTime time = life_.lifeTime();
  for (Column& column : columns_) {
    column.policy->advance(time);
    column.pi.resize(q_.size());
    column.policy->probabilities({q_, risk_, negative_}, column.pi);
    column.worth.resize(q_.size());
    column.policy->caution().weigh({q_, risk_, negative_}, column.worth);
  }
  sumLevels();
  setAccessibleDescription(sentence());
  const QFont font = textFont(13, 500);
  for (const double q : q_) numberWidth_ = std::max(numberWidth_, symbolWidth(font, valueText(q)) / textScale());
  update();
}

QString ActionRows::valueText(double q) {
  return fixedNumber(q, std::abs(q) < 99.95 ? 1 : 0);
}

/// Takes the values of the live state, or of the state that is examined on the map.
void ActionRows::takeValues() {
  const Shown& shown = looking_.shown();
  const std::vector<double>& state = looking_.examined();
  const ValueSnapshot* v = life_.values();
  chosen_ = kNoAction;
  if (state.size() != life_.task().state.size() || !v) {
    q_ = shown.q;
    positive_ = shown.qPositive;
    negative_ = shown.qNegative;
    risk_ = shown.risk;
    chosen_ = shown.action;
    return;
  }
  const auto n = static_cast<std::size_t>(v->values->actions());
  q_.resize(n);
  looking_.valuesShown()->evaluate(state, Layer::Sum, q_);
  for (auto* part : {&positive_, &negative_}) part->resize(looking_.valuesShown()->split() ? n : 0);
  risk_.resize(looking_.valuesShown()->hasRisk() ? n : 0);
  if (!risk_.empty()) looking_.valuesShown()->evaluate(state, Layer::Risk, risk_);
  if (!looking_.valuesShown()->split()) return;
  looking_.valuesShown()->evaluate(state, Layer::Positive, positive_);
  looking_.valuesShown()->evaluate(state, Layer::Negative, negative_);
}

/// The scale shows as much of the task's returns, from 0 to both sides, as the values have needed since the life began,
/// and more if they need more.
/// It never shrinks, and it does not move while the threshold is dragged.
void ActionRows::fitScale() {
  const double lowest = std::min(life_.task().lowestReturn, 0.0);
  const double highest = std::max(life_.task().highestReturn, lowest == 0 ? 1.0 : 0.0);
  const auto shareOf = [&](double v) { return v == 0 ? 0.0 : v > 0 ? v / highest : v / lowest; };
  double needed = share_;
  for (const auto* values : {&q_, &positive_, &negative_})
    for (const double v : *values) needed = std::max(needed, shareOf(v));
  if (const double t = life_.threshold(); life_.configuration().names.policy == "trl" && t >= lowest && t <= highest)
    needed = std::max(needed, shareOf(t));
  if (!dragging_) {
    share_ = 10;  // values may lie beyond every return while they learn
    for (const double share : {5.0, 3.0, 2.0, 1.5, 1.25, 1.0, 0.5, 0.2, 0.1, 0.05})
      if (needed <= share) share_ = share;
  }
  low_ = share_ * lowest, high_ = share_ * highest;
}

std::string ActionRows::asCsv() const {
  const auto& variables = life_.task().actionVariables;
  std::string csv = "action";
  for (const ActionVariable& v : variables) csv += "," + v.key;
  csv += positive_.empty() ? ",q" : ",q,q_positive,q_negative";
  if (!risk_.empty()) csv += ",risk";
  for (const Column& column : columns_) csv += "," + column.name;
  csv += '\n';
  for (std::size_t a = 0; a < q_.size(); ++a) {
    csv += fmt::format("{}", life_.task().actions[a]);
    for (std::size_t j = 0; j < variables.size(); ++j)
      csv += fmt::format(",{:.9g}", variables[j].levels[levelOf(life_.task(), a, j)]);
    csv += fmt::format(",{:.9g}", q_[a]);
    if (!positive_.empty()) csv += fmt::format(",{:.9g},{:.9g}", positive_[a], negative_[a]);
    if (!risk_.empty()) csv += fmt::format(",{:.9g}", risk_[a]);
    for (const Column& column : columns_) csv += fmt::format(",{:.9g}", column.pi[a]);
    csv += '\n';
  }
  return q_.empty() ? "" : csv;
}

bool ActionRows::onThreshold(const QPointF& at) const {
  const Geometry g = geometry();
  return life_.configuration().names.policy == "trl" && levels_.empty() &&
         std::abs(at.x() - xOf(life_.threshold(), g)) < 6 && at.y() > 6 && at.y() < g.bottom;
}

void ActionRows::mousePressEvent(QMouseEvent* event) {
  dragging_ = event->button() == Qt::LeftButton && onThreshold(mouseAt(*event));
  draggingLimit_ = event->button() == Qt::LeftButton && onRiskLimit(mouseAt(*event));
}

void ActionRows::mouseMoveEvent(QMouseEvent* event) {
  const bool on = onThreshold(mouseAt(*event)) || onRiskLimit(mouseAt(*event));
  setCursor(dragging_ || draggingLimit_ || on ? Qt::SplitHCursor : Qt::ArrowCursor);
  if (draggingLimit_) return dragRiskLimit(mouseAt(*event).x());
  if (!dragging_) return;
  const Geometry g = geometry();
  const double share = (mouseAt(*event).x() - g.qLeft) / (g.qRight - g.qLeft);
  const double value = std::round(std::clamp(low_ + share * (high_ - low_), low_ / share_, high_ / share_));
  if (value != life_.threshold())
    static_cast<void>(static_cast<bool>(editing_.setParameter("policy.threshold", value)));
}

void ActionRows::mouseReleaseEvent(QMouseEvent*) {
  draggingLimit_ = false;
  if (!std::exchange(dragging_, false)) return;
  fitScale();
  update();
}

}  // namespace surefoot

#include "moc_action_rows.cpp"
