// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
}

std::vector<Signal> signalsOf(const Environment& environment, bool hasRisk) {
  const Task& task = environment.task();
  std::vector<Signal> all;
  const auto add = [&](const std::string& key, const std::string& title, const std::string& symbol,
                       const std::string& unit, const char* group, Signal::Kind kind = Signal::Kind::Number) {
    all.push_back({.key = key, .title = title, .symbol = symbol, .unit = unit, .group = group, .kind = kind});
    const auto taken = [&](const Signal& other) { return &other != &all.back() && other.key == all.back().key; };
    if (std::any_of(all.begin(), all.end(), taken)) all.back().key += std::string("_") + group;
  };
  add("time", "time", "t", task.stepTime ? "s" : "steps", "time");
  add("episode", "episode", "", "", "time");
  for (const StateVariable& v : task.state) add(v.key, v.title, v.symbol, v.unit, "state");
  for (const Signal& s : environment.signals()) add(s.key, s.title, s.symbol, s.unit, s.group.c_str(), s.kind);
  for (const TaskMeasure& m : task.measures) add(m.key, m.title, "", m.unit, "measures");
  add("action", "number of the action", "", "", "action");
  for (const ActionVariable& v : task.actionVariables) add(v.key, v.title, v.symbol, v.unit, "action");
  if (task.actionVariables.empty()) add("action_value", task.actionTitle, task.actionSymbol, task.actionUnit, "action");
  add("value", "highest value", "V", "", "learner");
  add("q", "value of the action", "Q", "", "learner");
  if (hasRisk) add("risk", "risk of the action", "ρ", "", "learner");
  add("probability", "probability of the action", "π", "", "learner");
  add("explored", "the action explores", "", "", "learner", Signal::Kind::OnOff);
  add("td_error", "TD error", "δ", "", "learner");
  add("reward", "reward", "r", "", "reward");
  for (const std::string& term : task.rewardTerms) add("reward_" + term, "reward: " + term, "", "", "reward");
  add("fall", "a fall", "", "", "events", Signal::Kind::OnOff);
  add("end", "the episode ends", "", "", "events", Signal::Kind::OnOff);
  return all;
}

bool comesAfterAGap(const SignalTable& table, std::size_t row) {
  if (row == 0) return false;
  const std::vector<double>& time = table.columns()[0];
  return time[row] - time[row - 1] > 1.5 * table.stepTime();
}

std::size_t signalAt(const std::vector<Signal>& signals, std::string_view key) {
  const auto named = [&](const Signal& s) { return s.key == key; };
  return static_cast<std::size_t>(std::find_if(signals.begin(), signals.end(), named) - signals.begin());
}

SignalTable::SignalTable(const Environment& environment, bool hasRisk)
    : task_(environment.task()),
      signals_(signalsOf(environment, hasRisk)),
      columns_(signals_.size()),
      q_(signalAt(signals_, "q")),
      reward_(signalAt(signals_, "reward")),
      end_(signalAt(signals_, "end")),
      delta_(signalAt(signals_, "td_error")) {}

void SignalTable::before(const Moment& m) {
  std::size_t column = 0;
  const auto add = [&](double value) { columns_[column++].push_back(value); };
  const auto ofAction = [&](std::span<const double> values, bool known) {
    add(known ? values[static_cast<std::size_t>(m.action)] : kNone);
  };
  const bool acts = m.action >= 0, valued = acts && !m.q.empty();
  add(m.time);
  add(static_cast<double>(m.episode));
  for (const auto& part : {m.state, m.own, m.measures})
    for (const double value : part) add(value);
  add(acts ? static_cast<double>(m.action) : kNone);
  for (std::size_t j = 0; j < task_.actionVariables.size(); ++j)
    add(acts ? task_.actionVariables[j].levels[levelOf(task_, static_cast<std::size_t>(m.action), j)] : kNone);
  if (task_.actionVariables.empty()) ofAction(task_.actions, acts);
  add(m.q.empty() ? kNone : *std::max_element(m.q.begin(), m.q.end()));
  ofAction(m.q, valued);
  if (signals_[column].key == "risk") ofAction(m.risk, valued && !m.risk.empty());
  add(acts ? m.probability : kNone);
  add(acts && m.explores);
  while (column < columns_.size()) add(kNone);
}

void SignalTable::before(const Environment& environment, Moment moment) {
  own_.resize(environment.signals().size());
  environment.readSignals(own_);
  moment.state = environment.state(), moment.own = own_, moment.measures = environment.measures();
  before(moment);
}

void SignalTable::after(const Outcome& outcome) {
  last(reward_) = outcome.reward;
  for (std::size_t t = 0; t < task_.rewardTerms.size(); ++t) last(reward_ + 1 + t) = outcome.terms[t];
  last(end_ - 1) = outcome.event == Event::Fall;
  last(end_) = outcome.ending != Ending::None;
}

void SignalTable::learn(double discount) {
  if (rows() > 0 && last(end_) == 1.0) last(delta_) = last(reward_) - last(q_);
  if (rows() > 1 && last(end_, 1) == 0.0) last(delta_, 1) = last(reward_, 1) + discount * last(q_) - last(q_, 1);
}

void SignalTable::dropFirst(std::size_t count) {
  for (auto& column : columns_) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(count));
}

void SignalTable::dropLast() {
  for (auto& column : columns_) column.pop_back();
}

const std::vector<double>* SignalTable::column(std::string_view key) const {
  const std::size_t at = signalAt(signals_, key);
  return at < signals_.size() ? &columns_[at] : nullptr;
}

std::string SignalTable::asCsv() const {
  std::string text;
  for (std::size_t i = 0; i < signals_.size(); ++i) text += (i > 0 ? "," : "") + signals_[i].key;
  text += '\n';
  for (std::size_t row = 0; row < rows(); ++row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const double value = columns_[i][row];
      if (i > 0) text += ',';
      if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", value);
    }
    text += '\n';
  }
  return text;
}

}  // namespace surefoot
