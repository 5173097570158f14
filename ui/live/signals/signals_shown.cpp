// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/signals/signals_shown.h"

#include <QEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/style/policy_look.h"

namespace surefoot {

namespace {

constexpr int kStridesEvery = 1000;  // [ms]
constexpr int kMomentsEvery = 50;    // [ms]: more would cost the learner speed

QString titleOf(const RunningLife& life) {
  const Names& names = life.configuration().names;
  const auto policy = findEntry(life.registry().policies, "policy", names.policy);
  const auto agent = findEntry(life.registry().agents, "agent", names.agent);
  return fromCore(policy ? (*policy)->title : names.policy) + QStringLiteral(", ") +
         fromCore(agent ? (*agent)->title : names.agent);
}

}  // namespace

SignalsShown::SignalsShown(RunningLife& life, Looking& looking, QObject* parent)
    : QObject(parent),
      life_(life),
      looking_(looking) {
  sinceStrides_.start();
  sinceMoment_.start();
  connect(&looking_, &Looking::frame, this, &SignalsShown::nextFrame);
  connect(&looking_, &Looking::signalsReplaced, this, [this] {
    marked_.reset();
    part_.reset();
    followEnvironment();
    findStrides();
    Q_EMIT changed();
  });
}

void SignalsShown::watchedBy(QWidget& view) {
  view.installEventFilter(this);
  if (!view.isVisible()) return;
  visible_.insert(&view);
  watchSignals(&view, true);
}

void SignalsShown::watchSignals(const QObject* view, bool watches) {
  looking_.watchSignals(view, watches);
  if (beside_.looking) beside_.looking->watchSignals(view, watches);
}

void SignalsShown::setBeside(LifeBeside beside) {
  for (const QObject* view : visible_)
    if (beside_.looking) beside_.looking->watchSignals(view, false);
  beside_ = std::move(beside);
  for (const QObject* view : visible_) watchSignals(view, true);
  Q_EMIT changed();
}

bool SignalsShown::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
    const bool shows = event->type() == QEvent::Show;
    shows ? static_cast<void>(visible_.insert(watched)) : static_cast<void>(visible_.erase(watched));
    watchSignals(watched, shows);
    followEnvironment();
  }
  return QObject::eventFilter(watched, event);
}

const SignalTable& SignalsShown::table() const {
  return looking_.signals();
}

/// Not in a roll-out or a fall's replay, and only beside worlds that are the learners' own: others have other clocks.
bool SignalsShown::showsBeside() const {
  return beside_.looking && beside_.later() && looking_.showsLearner() && beside_.looking->showsLearner() &&
         looking_.secondSignals().rows() == 0;
}

const SignalTable& SignalsShown::second() const {
  return showsBeside() ? beside_.looking->signals() : looking_.secondSignals();
}

double SignalsShown::secondLater() const {
  return showsBeside() ? *beside_.later() : 0.0;
}

std::pair<QString, QString> SignalsShown::names() const {
  if (showsBeside()) return {tr("First: %1").arg(titleOf(life_)), tr("Second: %1").arg(titleOf(*beside_.life))};
  return {tr("What is learned here"), looking_.secondName()};
}

std::optional<std::size_t> SignalsShown::row() const {
  return looking_.signalRow();
}

bool SignalsShown::hasClock() const {
  return life_.task().stepTime.has_value();
}

QColor SignalsShown::learnerColour(const Theme& theme) const {
  return policyLook(life_.configuration().names.policy, theme).colour;
}

void SignalsShown::followEnvironment() {
  if (table().signals().empty() || environment_ == life_.configuration().names.environment) return;
  environment_ = life_.configuration().names.environment;
  strips_ = chosenStrips(environment_, table().signals());
  x_.clear();
  y_.clear();
  Q_EMIT changed();
}

void SignalsShown::setStrips(std::vector<Strip> strips) {
  strips_ = std::move(strips);
  keepStrips(environment_, strips_);
  Q_EMIT changed();
}

void SignalsShown::setUsualStrips() {
  strips_ = usualStrips(table().signals());
  keepStrips(environment_, {});
  Q_EMIT changed();
}

void SignalsShown::nextFrame() {
  if (visible_.empty() || sinceMoment_.elapsed() < kMomentsEvery) return;
  sinceMoment_.restart();
  if (!looking_.playback() && sinceStrides_.elapsed() > kStridesEvery) findStrides();
  Q_EMIT moment();
}

void SignalsShown::findStrides() {
  sinceStrides_.restart();
  std::vector<Stride> now = stridesOf(table());
  std::vector<Stride> beside = stridesOf(second());
  for (Stride& stride : beside) stride.begins += secondLater();
  const auto same = [](const std::vector<Stride>& a, const std::vector<Stride>& b) {
    return a.size() == b.size() && (a.empty() || a.back().begins == b.back().begins);
  };
  const bool all = same(now, strides_) && same(beside, secondStrides_);
  strides_ = std::move(now);
  secondStrides_ = std::move(beside);
  if (!all || looking_.playback()) Q_EMIT stridesChanged();
}

double SignalsShown::end() const {
  if (table().rows() == 0) return kLive;
  const std::vector<double>& time = table().columns()[0];
  const double step = life_.task().stepTime.value_or(1.0);
  return std::max(time.back(), second().rows() > 0 ? second().columns()[0].back() + secondLater() : 0.0) + step;
}

double SignalsShown::from() const {
  if (part_) return part_->first;
  if (looking_.playback()) return table().rows() > 0 ? table().columns()[0].front() : 0.0;
  const double length = hasClock() ? kLive : kLive / 0.05;
  return std::max(table().rows() > 0 ? table().columns()[0].front() : 0.0, end() - length);
}

double SignalsShown::to() const {
  if (part_) return part_->second;
  const double least = hasClock() ? 1.0 : 20.0;
  return std::max(end(), from() + least);
}

void SignalsShown::showAll() {
  part_.reset();
  Q_EMIT changed();
}

void SignalsShown::magnify(double factor, double around) {
  const double first = table().rows() > 0 ? table().columns()[0].front() : 0.0, last = end();
  const double least = 10.0 * life_.task().stepTime.value_or(1.0);
  const double length = std::max(least, (to() - from()) * factor);
  if (length >= last - first) return showAll();
  const double share = (around - from()) / (to() - from());
  const double begin = std::clamp(around - share * length, first, last - length);
  part_ = {begin, begin + length};
  Q_EMIT changed();
}

void SignalsShown::shift(double share) {
  if (!part_) return;
  const double length = part_->second - part_->first;
  const double first = table().rows() > 0 ? table().columns()[0].front() : 0.0;
  const double begin = std::clamp(part_->first + share * length, first, std::max(first, end() - length));
  part_ = {begin, begin + length};
  Q_EMIT changed();
}

void SignalsShown::seek(double time) {
  if (table().rows() == 0) return;
  const std::vector<double>& times = table().columns()[0];
  const auto at = std::lower_bound(times.begin(), times.end(), time);
  const auto row = static_cast<std::size_t>(std::min<std::ptrdiff_t>(at - times.begin(), std::ssize(times) - 1));
  const bool before = row > 0 && time - times[row - 1] < times[row] - time;
  looking_.seekRow(before ? row - 1 : row);
}

std::pair<std::size_t, std::size_t> SignalsShown::axes() const {
  const auto& signals = table().signals();
  std::size_t x = signalAt(signals, x_), y = signalAt(signals, y_);
  std::vector<std::size_t> states;
  for (std::size_t i = 0; i < signals.size(); ++i)
    if (signals[i].group == "state") states.push_back(i);
  if (x == signals.size()) x = states.empty() ? 0 : states[0];
  // Beside an angle, its rate: the first variable whose unit is that of x a second.
  if (y == signals.size()) {
    y = states.size() > 1 ? states[1] : x;
    for (const std::size_t at : states)
      if (at != x && signals[at].unit == signals[x].unit + "/s") {
        y = at;
        break;
      }
  }
  return {x, y};
}

void SignalsShown::setAxes(const std::string& x, const std::string& y) {
  x_ = x, y_ = y;
  Q_EMIT changed();
}

void SignalsShown::markStride(std::optional<MarkedStride> stride) {
  marked_ = stride;
  if (!marked()) marked_.reset();
  Q_EMIT changed();
}

/// nullptr: none is marked, or it is there no more.
const Stride* SignalsShown::marked() const {
  if (!marked_) return nullptr;
  const auto& strides = marked_->ofSecond ? secondStrides_ : strides_;
  return marked_->stride < strides.size() ? &strides[marked_->stride] : nullptr;
}

std::optional<std::pair<double, double>> SignalsShown::band() const {
  const Stride* s = marked();
  return s ? std::optional(std::pair{s->begins, s->begins + s->duration}) : std::nullopt;
}

std::optional<std::pair<std::size_t, std::size_t>> SignalsShown::cycle(const SignalTable& of,
                                                                       const std::vector<Stride>& strides) const {
  const Stride* s = marked();
  if (s && marked_->ofSecond == (&of == &second())) return std::pair{s->from, s->to};
  if (!strides.empty()) return std::pair{strides.back().from, strides.back().to};
  if (of.rows() < 3) return std::nullopt;
  const auto* column = columnLike(of, table(), axes().first);
  if (!column) return std::nullopt;
  const std::vector<double>&x = *column, &episode = of.columns()[1];
  double sum = 0.0;
  for (const double v : x) sum += std::isnan(v) ? 0.0 : v;
  const double mean = sum / static_cast<double>(x.size());
  std::optional<std::size_t> upper;
  for (std::size_t row = x.size() - 1; row > 0; --row) {
    if (episode[row] != episode[row - 1]) upper.reset();
    if (!(x[row - 1] < mean && x[row] >= mean)) continue;
    if (upper && *upper - row > 3) return std::pair{row, *upper};
    if (!upper) upper = row;
  }
  return std::nullopt;
}

}  // namespace surefoot

#include "moc_signals_shown.cpp"
