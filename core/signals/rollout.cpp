// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/rollout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/life/life_measures.h"
#include "core/values_of_state.h"

namespace surefoot {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Writes the rows, in the order of signalsOf().
class Recorder {
 public:
  Recorder(const Environment& environment, const ActionValueFunction& values, Rollout& to)
      : environment_(environment),
        to_(to),
        hasRisk_(values.hasRisk()) {
    to_.signals = signalsOf(environment, values);
    to_.columns.resize(to_.signals.size());
    own_.resize(environment.signals().size());
    while (to_.signals[delta_].key != "td_error") ++delta_;
  }

  /// The moment before an action.
  void before(double time, const ValuesOfState& here, std::span<const double> pi, Action a, bool explores) {
    column_ = 0;
    const auto at = static_cast<std::size_t>(a);
    const Task& task = environment_.task();
    add(time);
    add(static_cast<double>(to_.episodes));
    for (const double s : environment_.state()) add(s);
    environment_.readSignals(own_);
    for (const double value : own_) add(value);
    add(static_cast<double>(a));
    for (std::size_t j = 0; j < task.actionVariables.size(); ++j)
      add(task.actionVariables[j].levels[levelOf(task, at, j)]);
    if (task.actionVariables.empty()) add(task.actions[at]);
    add(*std::max_element(here.q.begin(), here.q.end()));
    add(here.q[at]);
    if (hasRisk_) add(here.risk[at]);
    add(pi[at]);
    add(explores);
  }
  /// What the action brought.
  void after(const Outcome& outcome) {
    add(outcome.reward);
    for (std::size_t t = 0; t < environment_.task().rewardTerms.size(); ++t) add(outcome.terms[t]);
    add(outcome.event == Event::Fall);
    add(outcome.ending != Ending::None);
    add(kNone);  // δ, which the next row knows
  }
  void setDelta(double delta) { to_.columns[delta_].back() = delta; }

 private:
  void add(double value) { to_.columns[column_++].push_back(value); }

  const Environment& environment_;
  Rollout& to_;
  bool hasRisk_;
  std::vector<double> own_;
  std::size_t column_ = 0, delta_ = 0;
};

/// Measures with one more episode, as a life adds them up.
void addMeasures(const Environment& environment, bool first, std::vector<double>& all) {
  const auto& measures = environment.task().measures;
  const auto values = environment.measures();
  for (std::size_t m = 0; m < measures.size(); ++m) all[m] = together(measures[m].ofALife, all[m], values[m], first);
}

}  // namespace

const std::vector<double>* Rollout::column(std::string_view key) const {
  for (std::size_t i = 0; i < signals.size(); ++i)
    if (signals[i].key == key) return &columns[i];
  return nullptr;
}

std::vector<Signal> signalsOf(const Environment& environment, const ActionValueFunction& values) {
  const Task& task = environment.task();
  std::vector<Signal> all;
  const auto add = [&](const std::string& key, const std::string& title, const std::string& symbol,
                       const std::string& unit, const char* group, Signal::Kind kind = Signal::Kind::Number) {
    all.push_back({.key = key, .title = title, .symbol = symbol, .unit = unit, .group = group, .kind = kind});
  };
  add("time", "time", "t", task.stepTime ? "s" : "steps", "time");
  add("episode", "episode", "", "", "time");
  for (const StateVariable& v : task.state) add(v.key, v.title, v.symbol, v.unit, "state");
  for (const Signal& signal : environment.signals()) {
    all.push_back(signal);
    const auto taken = [&](const StateVariable& v) { return v.key == signal.key; };
    if (std::any_of(task.state.begin(), task.state.end(), taken)) all.back().key += "_signal";
  }
  add("action", "number of the action", "", "", "action");
  for (const ActionVariable& v : task.actionVariables) add(v.key, v.title, v.symbol, v.unit, "action");
  if (task.actionVariables.empty()) add("action_value", task.actionTitle, task.actionSymbol, task.actionUnit, "action");
  add("value", "highest value of an action", "V", "", "learner");
  add("q", "value of the action", "Q", "", "learner");
  if (values.hasRisk()) add("risk", "risk of the action", "ρ", "", "learner");
  add("probability", "probability of the action", "π", "", "learner");
  add("explored", "the action explores", "", "", "learner", Signal::Kind::OnOff);
  add("reward", "reward", "r", "", "reward");
  for (const std::string& term : task.rewardTerms) add("reward_" + term, "reward: " + term, "", "", "reward");
  add("fall", "a fall", "", "", "events", Signal::Kind::OnOff);
  add("end", "the episode ends", "", "", "events", Signal::Kind::OnOff);
  add("td_error", "TD error", "δ", "", "learner");
  return all;
}

Rollout rollOut(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                const RolloutSettings& settings, const std::atomic<bool>* interrupted) {
  Rollout rollout;
  rollout.measures.assign(environment.task().measures.size(), 0.0);
  Recorder recorder(environment, values, rollout);
  Random world(deriveSeed(settings.seed, 0, Stream::World)), policyRandom(deriveSeed(settings.seed, 0, Stream::Policy));
  const double stepTime = environment.task().stepTime.value_or(1.0);
  ValuesOfState here;
  std::vector<double> pi(environment.task().actions.size());
  std::size_t push = 0;
  double reward = 0.0, q = 0.0;  // of the step before
  bool running = false;

  while (rollout.steps < settings.steps && !(interrupted && *interrupted)) {
    if (!running) {
      if (settings.episodes && rollout.episodes == *settings.episodes) break;
      environment.reset(world);
      if (rollout.stopped = environment.unanswered(); !rollout.stopped.empty()) break;
      if (rollout.episodes == 0 && !settings.start.empty()) environment.place(settings.start);
      ++rollout.episodes;
    }
    const double time = static_cast<double>(rollout.steps) * stepTime;
    here.evaluate(values, environment.state());
    const auto [action, explores] = policy.draw(here.view(), pi, policyRandom);
    const double now = here.q[static_cast<std::size_t>(action)];
    if (running) recorder.setDelta(reward + settings.discount * now - q);
    for (; push < settings.pushes.size() && settings.pushes[push].time <= time + 1e-9; ++push)
      environment.push(settings.pushes[push].impulse);
    recorder.before(time, here, pi, action, explores);
    const Outcome outcome = environment.step(action);
    recorder.after(outcome);
    if (outcome.ending == Ending::Unanswered) {
      rollout.stopped = environment.unanswered();
      break;
    }
    ++rollout.steps;
    reward = outcome.reward, q = now;
    rollout.reward += outcome.reward;
    rollout.falls += outcome.event == Event::Fall;
    rollout.successes += outcome.event == Event::Success;
    running = outcome.ending == Ending::None;
    if (outcome.ending == Ending::Terminal) recorder.setDelta(reward - q);
    if (!running) {
      addMeasures(environment, rollout.episodes == 1, rollout.measures);
      if (rollout.stopped = environment.failure(); !rollout.stopped.empty()) break;
    }
  }
  if (running) addMeasures(environment, rollout.episodes == 1, rollout.measures);
  const auto& measures = environment.task().measures;
  for (std::size_t m = 0; m < measures.size(); ++m)
    rollout.measures[m] = valueOfALife(measures[m], rollout.measures[m], rollout.episodes);
  return rollout;
}

}  // namespace surefoot
