// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/rollout.h"

#include "core/life/life_measures.h"

namespace surefoot {

namespace {

/// Measures with one more episode, as a life adds them up.
void addMeasures(const Environment& environment, bool first, std::vector<double>& all) {
  const auto& measures = environment.task().measures;
  const auto values = environment.measures();
  for (std::size_t m = 0; m < measures.size(); ++m) all[m] = together(measures[m].ofALife, all[m], values[m], first);
}

/// Pushes of an episode by its steps.
void pushAt(std::size_t step, const EpisodeInputs& inputs, Environment& environment) {
  for (std::size_t i = 0; i < inputs.pushSteps.size(); ++i)
    if (inputs.pushSteps[i] == step) environment.push(inputs.pushImpulses[i]);
}

}  // namespace

Rollout rollOut(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                const RolloutSettings& settings, const std::atomic<bool>* interrupted) {
  Rollout rollout{.table = SignalTable(environment, values.hasRisk()), .measures = {}};
  rollout.measures.assign(environment.task().measures.size(), 0.0);
  Random world(deriveSeed(settings.seed, 0, Stream::World)), policyRandom(deriveSeed(settings.seed, 0, Stream::Policy));
  const double stepTime = environment.task().stepTime.value_or(1.0);
  ValuesOfState here;
  std::vector<double> pi(environment.task().actions.size());
  std::size_t push = 0;
  bool running = false;

  while (rollout.steps < settings.steps && !(interrupted && *interrupted)) {
    if (!running) {
      if (settings.episodes && rollout.episodes == *settings.episodes) break;
      const EpisodeInputs* as = rollout.episodes == 0 ? settings.as : nullptr;
      if (as) world = Random(as->random);
      environment.reset(world);
      if (rollout.stopped = environment.unanswered(); !rollout.stopped.empty()) break;
      const std::vector<double>& start = as ? as->start : settings.start;
      if (rollout.episodes == 0 && !start.empty()) environment.place(start);
      ++rollout.episodes;
    }
    const double time = static_cast<double>(rollout.steps) * stepTime;
    here.evaluate(values, environment.state());
    const auto [action, explores] = policy.draw(here.view(), pi, policyRandom);
    for (; push < settings.pushes.size() && settings.pushes[push].time <= time + 1e-9; ++push)
      environment.push(settings.pushes[push].impulse);
    if (settings.as && rollout.episodes == 1)
      pushAt(static_cast<std::size_t>(rollout.steps), *settings.as, environment);
    rollout.table.before(environment, {.time = time,
                                       .episode = rollout.episodes,
                                       .q = here.q,
                                       .risk = here.risk,
                                       .action = action,
                                       .probability = pi[static_cast<std::size_t>(action)],
                                       .explores = explores});
    rollout.table.learn(settings.discount);
    if (settings.see) settings.see({environment, here, time, rollout.steps, action});
    const Outcome outcome = environment.step(action);
    rollout.table.after(outcome);
    if (outcome.ending == Ending::Unanswered) {
      rollout.stopped = environment.unanswered();
      break;
    }
    ++rollout.steps;
    rollout.reward += outcome.reward;
    rollout.falls += outcome.event == Event::Fall;
    rollout.successes += outcome.event == Event::Success;
    running = outcome.ending == Ending::None;
    if (outcome.ending == Ending::Terminal) rollout.table.learn(settings.discount);
    if (!running) {
      if (settings.see) {
        here.evaluate(values, environment.state());
        settings.see({environment, here, static_cast<double>(rollout.steps) * stepTime, rollout.steps - 1, kNoAction,
                      outcome.event == Event::Fall});
      }
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

SignalTable relive(Environment& environment, const EpisodeInputs& inputs, const ActionValueFunction* values,
                   const Policy& policy, double discount, const SeeMoment& see) {
  const SignalTable none(environment, values && values->hasRisk());
  SignalTable table = none;
  ValuesOfState here;
  std::vector<double> pi(environment.task().actions.size());
  const bool knowsExplored = inputs.explored.size() == inputs.actions.size();
  Random random(inputs.random);
  Ending ending = Ending::None;
  std::size_t step = 0;
  const bool whole = repeat(inputs, environment, random, ending, [&](const Outcome& before, Action next) {
    if (step > 0) table.after(before);
    if (before.ending == Ending::Terminal) table.learn(discount);
    if (values) {
      here.evaluate(*values, environment.state());
      policy.probabilities(here.view(), pi);
    }
    const double time = static_cast<double>(step) * table.stepTime();
    table.before(environment,
                 {.time = time,
                  .q = here.q,
                  .risk = here.risk,
                  .action = next,
                  .probability = next < 0 ? 0.0 : pi[static_cast<std::size_t>(next)],
                  .explores = step < inputs.actions.size() && knowsExplored && inputs.explored[step] != 0});
    if (step < inputs.actions.size()) table.learn(discount);
    if (see) see({environment, here, time, static_cast<std::int64_t>(step), next, before.event == Event::Fall});
    ++step;
  });
  return whole && ending != Ending::Unanswered ? table : none;
}

}  // namespace surefoot
