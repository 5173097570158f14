// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/policies/register.h"

#include "core/policies/epsilon_greedy.h"
#include "core/policies/greedy.h"
#include "core/policies/mellowmax.h"
#include "core/policies/softmax.h"
#include "core/policies/threshold_restricted.h"

namespace surefoot {

namespace {

template <class P>
std::unique_ptr<Policy> makePolicy() {
  return std::make_unique<P>();
}

}  // namespace

void registerPolicies(Registry& r) {
  r.policies.push_back(
      {{"epsilon-greedy", "ε-greedy", "The best action, but any with probability ε."}, makePolicy<EpsilonGreedy>});
  r.policies.push_back(
      {{"trl", "TRL", "ε-greedy that explores among the actions above a threshold."}, makePolicy<ThresholdRestricted>});
  r.policies.push_back(
      {{"softmax", "Softmax", "The better an action, the likelier, by a temperature."}, makePolicy<Softmax>});
  r.policies.push_back({{"mellowmax", "Mellowmax", "As Softmax, with a temperature that fits each state by itself."},
                        makePolicy<Mellowmax>});
  r.policies.push_back({{"greedy", "Greedy", "Always the best action."}, makePolicy<Greedy>});
}

}  // namespace surefoot
