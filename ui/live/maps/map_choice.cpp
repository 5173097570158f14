// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/maps/map_choice.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"

namespace surefoot {

namespace {

/// The i-th point of Halton's sequence (1960) in a prime base, 0 … 1: samples that fill a space evenly.
double halton(int i, int base) {
  double f = 1.0, r = 0.0;
  for (; i > 0; i /= base) f /= base, r += f * (i % base);
  return r;
}

constexpr int kPrimes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29};
constexpr int kSamples = 8, kMostSamples = 24;

}  // namespace

void MapChoice::fit(const Task& task) {
  const std::size_t n = task.state.size();
  x = 0;
  y = n > 1 ? 1 : 0;
  across.assign(n, Across::Live);
  fixed.assign(n, 0.0);
  action = 0;
  if (quantity == MapQuantity::OneAction) quantity = MapQuantity::BestAction;
  locked = task.goalReward.has_value();  // without a goal no value comes near the reward of a whole episode
}

bool MapChoice::suits(const Task& task) const {
  const bool joints = quantity == MapQuantity::GreedyAction && !task.actionVariables.empty();
  const std::size_t numbered = joints ? task.actionVariables.size() : task.actions.size();
  return across.size() == task.state.size() && static_cast<std::size_t>(action) < numbered;
}

MapSlice MapChoice::slice(std::span<const double> live) const {
  MapSlice slice{x, y, {live.begin(), live.end()}};
  for (std::size_t d = 0; d < slice.at.size() && d < across.size(); ++d)
    if (across[d] == Across::Fixed && !isAxis(d)) slice.at[d] = fixed[d];
  return slice;
}

ValueMap::Quantity MapChoice::projected(const Task& task, ValueMap::Quantity whole) const {
  std::vector<std::size_t> over;
  for (std::size_t d = 0; d < across.size(); ++d)
    if (across[d] == Across::Projected && !isAxis(d)) over.push_back(d);
  if (over.empty()) return whole;
  const int samples = std::min(kMostSamples, kSamples * static_cast<int>(over.size()));
  return [=, this, &task, state = std::vector<double>()](std::span<const double> at) mutable {
    state.assign(at.begin(), at.end());
    double sum = 0, least = std::numeric_limits<double>::infinity(), most = -least;
    int seen = 0;
    for (int i = 0; i < samples; ++i) {
      for (std::size_t k = 0; k < over.size(); ++k) {
        const StateVariable& v = task.state[over[k]];
        state[over[k]] = v.viewLow + (v.viewHigh - v.viewLow) * halton(i + 1, kPrimes[k % std::size(kPrimes)]);
        if (v.whole) state[over[k]] = std::clamp(std::round(state[over[k]]), v.low, v.high);
      }
      const double value = whole(state);
      if (std::isnan(value)) continue;
      ++seen;
      sum += value;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (seen == 0) return std::numeric_limits<double>::quiet_NaN();
    return projection == Projection::Mean ? sum / seen : projection == Projection::Least ? least : most;
  };
}

std::size_t greedyValues(const MapChoice& choice, const Task& task) {
  return task.actionVariables.empty() ? task.actions.size()
                                      : task.actionVariables[static_cast<std::size_t>(choice.action)].levels.size();
}

QString greedyNameOf(const MapChoice& choice, const Task& task, std::size_t value) {
  if (task.actionVariables.empty()) return actionNameOf(task, value);
  return fixedNumber(task.actionVariables[static_cast<std::size_t>(choice.action)].levels[value], 1);
}

QString quantityText(const MapChoice& choice, const Task& task) {
  switch (choice.quantity) {
    case MapQuantity::BestAction:
      return QObject::tr("best action");
    case MapQuantity::OneAction:
      return fromCore(task.actionTitle) + ' ' + actionNameOf(task, static_cast<std::size_t>(choice.action));
    case MapQuantity::GreedyAction:
      return task.actionVariables.empty()
                 ? QObject::tr("greedy action")
                 : QObject::tr("greedy %1")
                       .arg(fromCore(task.actionVariables[static_cast<std::size_t>(choice.action)].title));
    case MapQuantity::Risk:
      return QObject::tr("risk of a fall");
    case MapQuantity::Visits:
      return QObject::tr("visits");
    case MapQuantity::Eligibility:
      break;
  }
  return QObject::tr("eligibility");
}

QString axesText(const MapChoice& choice, const Task& task) {
  if (choice.x == choice.y) return symbolOf(task.state[static_cast<std::size_t>(choice.x)]);
  return QStringLiteral("%1 × %2").arg(symbolOf(task.state[static_cast<std::size_t>(choice.x)]),
                                       symbolOf(task.state[static_cast<std::size_t>(choice.y)]));
}

QString othersText(const MapChoice& choice, const Task& task, std::span<const double> live) {
  std::vector<std::size_t> others;
  for (std::size_t d = 0; d < task.state.size(); ++d)
    if (!choice.isAxis(d)) others.push_back(d);
  if (others.empty()) return {};
  if (others.size() > 1) return QObject::tr("%1 others").arg(others.size());
  const std::size_t d = others[0];
  const QString symbol = symbolOf(task.state[d]);
  const auto number = [](double v) { return fixedNumber(v, 1); };
  switch (choice.across[d]) {
    case Across::Live:
      return d < live.size() ? QObject::tr("%1 live %2").arg(symbol, number(live[d]))
                             : QObject::tr("%1 live").arg(symbol);
    case Across::Fixed:
      return QObject::tr("%1 fixed %2").arg(symbol, number(choice.fixed[d]));
    case Across::Projected:
      break;
  }
  return choice.projection == Projection::Mean    ? QObject::tr("mean over %1").arg(symbol)
         : choice.projection == Projection::Least ? QObject::tr("least over %1").arg(symbol)
                                                  : QObject::tr("most over %1").arg(symbol);
}

}  // namespace surefoot
