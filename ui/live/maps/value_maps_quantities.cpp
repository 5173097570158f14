// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ValueMaps for the quantities of its maps.
#include <algorithm>

#include "core/values_of_state.h"
#include "ui/live/maps/value_maps.h"
#include "ui/running/looking.h"
#include "ui/running/running_life.h"

namespace surefoot {

/// q̂ of the best action or of the chosen one, or the number of the greedy action.
ValueMap::Quantity ValueMaps::quantity(Layer layer) const {
  const ActionValueFunction& values = *looking_.valuesShown();
  return [this, layer, &values, q = std::vector<double>(static_cast<std::size_t>(values.actions())),
          here = ValuesOfState()](std::span<const double> s) mutable {
    if (values.familiarity(s) < kFamiliar) return kNever;
    values.evaluate(s, layer, q);
    if (choice_.quantity == MapQuantity::OneAction) return q[static_cast<std::size_t>(choice_.action)];
    if (choice_.quantity != MapQuantity::GreedyAction) return *std::max_element(q.begin(), q.end());
    here.evaluate(values, s);
    policy_->greedy(here.view(), q);
    const auto action = static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin());
    const Task& task = life_.task();
    return static_cast<double>(
        task.actionVariables.empty() ? action : levelOf(task, action, static_cast<std::size_t>(choice_.action)));
  };
}

/// The best actions, one bit for each: several of them are worth the same. Under a rule of caution only those that the
/// greedy policy takes.
ValueMap::Quantity ValueMaps::bestActions() const {
  constexpr double kSame = 1e-9;  // of the largest value
  const ActionValueFunction& values = *looking_.valuesShown();
  return [this, &values, here = ValuesOfState(),
          q = std::vector<double>(static_cast<std::size_t>(values.actions()))](std::span<const double> s) mutable {
    if (values.familiarity(s) < kFamiliar) return kNever;
    values.evaluate(s, Layer::Sum, q);
    if (here.evaluate(values, s); policy_->caution().actsOn(here.view())) policy_->greedy(here.view(), q);
    const double best = *std::max_element(q.begin(), q.end());
    std::uint32_t bits = 0;
    for (std::size_t a = 0; a < q.size() && a < 32; ++a)
      if (q[a] >= best - kSame * std::max(1.0, std::abs(best))) bits |= 1u << a;
    return static_cast<double>(bits);
  };
}

// Both parts of the action that is best by their sum, so that the large map is the sum of the small ones.
ValueMap::Quantity ValueMaps::partOf(Layer layer) const {
  if (choice_.quantity == MapQuantity::OneAction) return quantity(layer);
  const ActionValueFunction& values = *looking_.valuesShown();
  const auto n = static_cast<std::size_t>(values.actions());
  return
      [layer, &values, q = std::vector<double>(n), part = std::vector<double>(n)](std::span<const double> s) mutable {
        if (values.familiarity(s) < kFamiliar) return kNever;
        values.evaluate(s, Layer::Sum, q);
        values.evaluate(s, layer, part);
        return part[static_cast<std::size_t>(std::max_element(q.begin(), q.end()) - q.begin())];
      };
}

/// ρ of the action that the greedy policy takes, or of the chosen one.
ValueMap::Quantity ValueMaps::risk() const {
  const ActionValueFunction& values = *looking_.valuesShown();
  return [this, &values, here = ValuesOfState(),
          pi = std::vector<double>(static_cast<std::size_t>(values.actions()))](std::span<const double> s) mutable {
    if (values.familiarity(s) < kFamiliar) return kNever;
    here.evaluate(values, s);
    if (choice_.quantity == MapQuantity::OneAction) return here.risk[static_cast<std::size_t>(choice_.action)];
    policy_->greedy(here.view(), pi);
    return here.risk[static_cast<std::size_t>(std::max_element(pi.begin(), pi.end()) - pi.begin())];
  };
}

ValueMap::Quantity ValueMaps::visits() const {
  const ActionValueFunction& values = *looking_.valuesShown();
  return [&values](std::span<const double> s) { return values.familiarity(s) < kFamiliar ? kNever : values.visits(s); };
}

ValueMap::Quantity ValueMaps::eligibility() const {
  const ValueSnapshot& v = *life_.values();
  return
      [&v, z = std::vector<double>(static_cast<std::size_t>(v.values->actions()))](std::span<const double> s) mutable {
        if (v.values->familiarity(s) < kFamiliar) return kNever;
        v.values->average(v.eligibility, s, z);
        return *std::max_element(z.begin(), z.end());
      };
}

}  // namespace surefoot
