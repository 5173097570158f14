// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/growing_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/findings/growth.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

/// A measure that no task of the plan has would be missed only after all the lives.
Status checkMeasures(const Registry& registry, const Plan& plan) {
  std::set<std::string> environments;
  for (const Condition& c : plan.conditions) environments.insert(c.configuration.names.environment);
  const auto known = measureNames(taskMeasuresOf(registry, environments));
  std::vector<std::string> wanted;
  if (const auto& d = plan.growth.decided) wanted = {d->measure};
  if (const auto& s = plan.growth.search) wanted = {s->minimise, s->keeping};
  for (const std::string& measure : wanted)
    if (std::find(known.begin(), known.end(), measure) == known.end())
      return Error{fmt::format("{}: there is no measure \"{}\"; it takes {}.",
                               plan.growth.decided ? "decided" : "search", shortened(measure), joinWords(known, "or"))};
  return Done{};
}

}  // namespace

Result<LabResult> runGrowing(const Registry& registry, const Plan& plan, Store& store,
                             const std::function<Result<LabResult>(const Plan&)>& live) {
  if (const Status s = checkMeasures(registry, plan); !s) return s.error();
  Plan now = plan;
  LabResult all;
  for (;;) {
    const auto stored = store.plan();
    if (!stored) return stored.error();
    now.livesEach.clear();
    for (const StoredCondition& c : stored->conditions) now.livesEach.push_back(c.lives);
    auto result = live(now);
    if (!result) return result;
    result->preLearningsAtCap += all.preLearningsAtCap;
    all = std::move(*result);
    if (!all.complete()) return all;
    const auto evidence = readEvidence(registry, store);
    if (!evidence) return evidence.error();
    GrowthState state = growthOf(plan.growth, *evidence);
    if (state.lives == now.livesEach) {
      all.found = std::move(state.sentences);
      return all;
    }
    if (const Status s = store.setLives(state.lives); !s) return s.error();
  }
}

}  // namespace surefoot
