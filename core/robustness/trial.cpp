// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/robustness/trial.h"

#include <algorithm>

#include "core/values_of_state.h"

namespace surefoot {

std::int64_t momentOf(const Trial& t) {
  Random moments(deriveSeed(t.seed, t.number, Stream::Tests));
  const double steps = moments.uniform() * static_cast<double>(t.latest - t.earliest + 1);
  return std::min(t.latest, t.earliest + static_cast<std::int64_t>(steps));
}

Result<TrialEnd> tryOnce(Environment& environment, const ActionValueFunction& values, const Policy& policy,
                         const Trial& t, const std::atomic<bool>* interrupted) {
  Random world(deriveSeed(t.seed, t.number, Stream::World)), draws(deriveSeed(t.seed, t.number, Stream::Policy));
  ValuesOfState here;
  std::vector<double> pi(environment.task().actions.size());
  const std::int64_t moment = momentOf(t), end = moment + t.after;
  bool running = false;
  environment.setCutOffs({});  // those of other trials are none of its own

  for (std::int64_t step = 0; step < end; ++step) {
    if (interrupted && interrupted->load(std::memory_order_relaxed)) break;
    if (!running) {
      environment.reset(world);
      if (std::string why = environment.unanswered(); !why.empty()) return Error{why, ErrorKind::Unanswered};
    }
    here.evaluate(values, environment.state());
    const Action action = policy.draw(here.view(), pi, draws).action;
    if (step == moment && t.impulse != 0.0) environment.push(t.impulse);
    const std::int64_t whole = environment.cutOffs().all;
    const Outcome outcome = environment.step(action);
    if (outcome.ending == Ending::Unanswered) return Error{environment.unanswered(), ErrorKind::Unanswered};
    running = outcome.ending == Ending::None;
    if (step < moment) {
      if (!running && !environment.failure().empty()) return TrialEnd::FlewApart;
      continue;
    }
    if (outcome.event == Event::Fall) return TrialEnd::Fell;
    if (outcome.event == Event::Success) return TrialEnd::Succeeded;
    if (!running) return environment.cutOffs().all > whole ? TrialEnd::FlewApart : TrialEnd::Held;
  }
  return TrialEnd::Held;
}

}  // namespace surefoot
