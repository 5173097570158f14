// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/caution.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {
constexpr const char* kRules[] = {"off", "weight", "filter", "explore", "losses"};
constexpr const char* kGuardians[] = {"nobody", "hand-made", "q-function"};
}  // namespace

const char* nameOf(CautionRule rule) {
  return kRules[static_cast<int>(rule)];
}

Status Caution::check(const CautionNeeds& has) const {
  if (guardedBy_ == GuardedBy::HandMade && !has.handMade)
    return Error{"policy.guardian = hand-made: the environment has no hand-made controller; choose nobody."};
  if (guardedBy_ == GuardedBy::QFunction && !has.guardian)
    return Error{"policy.guardian = q-function: there is none; name its file, policy.guardian = FILE."};
  if (guards() && !has.risk)
    return Error{
        fmt::format("policy.guardian = {}: it needs the risk of a fall, which is learned with risk.learn = on.",
                    kGuardians[static_cast<int>(guardedBy_)])};
  if (rule_ == CautionRule::Off || (rule_ == CautionRule::Losses ? has.losses : has.risk)) return Done{};
  return Error{fmt::format("policy.risk = {}: it needs {}.", nameOf(rule_),
                           rule_ == CautionRule::Losses ? "expected losses apart, as the agent sarsa-2q learns them"
                                                        : "the risk of a fall, which is learned with risk.learn = on")};
}

void Caution::declare(Fields& f) {
  f.choice(rule_, {.key = "risk",
                   .title = "Caution",
                   .when = When::Now,
                   .group = Group::Risk,
                   .help = "What the policy does with the risk of a fall, or with the losses of Sarsa_2Q.",
                   .origin = "ours: off, as in the thesis",
                   .choices = {std::begin(kRules), std::end(kRules)}});
  const auto declare = [&](Scheduled& value, std::vector<std::string> rules, Parameter p) {
    p.when = When::Now, p.group = Group::Risk, p.needs = "risk", p.needsOne = std::move(rules);
    value.declare(f, p);
  };
  declare(weight_, {"weight"},
          {.key = "risk_weight",
           .title = "Weight of risk",
           .symbol = "w",
           .low = 0.0,
           .high = 1e6,
           .sliderLow = 0.0,
           .sliderHigh = 6400.0,
           .help = "A certain fall costs an action so much of its value.",
           .origin = "ours: on top of the reward of a fall"});
  declare(limit_, {"filter", "explore"},
          {.key = "risk_limit",
           .title = "Limit of risk",
           .low = 0.0,
           .high = 1.0,
           .sliderLow = 0.0,
           .sliderHigh = 1.0,
           .sliderBend = 0.01,
           .help = "Actions that fall with a higher probability are left out.",
           .origin = "ours"});
  declare(factor_, {"losses"},
          {.key = "losses_factor",
           .title = "Factor of losses",
           .symbol = "k",
           .low = 0.0,
           .high = 1e4,
           .sliderLow = 0.0,
           .sliderHigh = 64.0,
           .help = "Expected losses count so many times.",
           .origin = "ours: 1 is Sarsa_2Q of the thesis"});
  f.choice(guardedBy_, {.key = "guardian",
                        .title = "Guardian",
                        .when = When::Now,
                        .group = Group::Risk,
                        .help = "Who acts while the policy's action is too risky: the robot's own controller, or a "
                                "Q-function of a file. The learner learns from it.",
                        .origin = "ours: nobody, as in the thesis",
                        .choices = {std::begin(kGuardians), std::end(kGuardians)},
                        .order = 3});
  f.real(guardianLimit_, {.key = "guardian_limit",
                          .title = "Limit of the guardian",
                          .label = "Guardian from",
                          .low = 0.0,
                          .high = 1.0,
                          .when = When::Now,
                          .group = Group::Risk,
                          .help = "The guardian acts from this risk on, until the risk is below half of it.",
                          .origin = "ours",
                          .order = 3,
                          .needs = "guardian"});
}

void Caution::advance(const LifeTime& time) {
  for (Scheduled* value : {&weight_, &limit_, &factor_}) value->advance(time);
}

bool Caution::everyStep() const {
  return weight_.everyStep() || limit_.everyStep() || factor_.everyStep();
}

void Caution::weigh(const ActionView& v, std::span<double> worth) const {
  std::copy(v.q.begin(), v.q.end(), worth.begin());
  if (!actsOn(v)) return;
  switch (rule_) {
    case CautionRule::Off:
      return;
    case CautionRule::Weight:
      for (std::size_t a = 0; a < worth.size(); ++a) worth[a] -= weight_.now() * v.risk[a];
      return;
    case CautionRule::Losses:
      for (std::size_t a = 0; a < worth.size(); ++a) worth[a] += (factor_.now() - 1.0) * v.losses[a];
      return;
    case CautionRule::Filter:
      return allow(v, false, worth);
    case CautionRule::Explore:
      return allow(v, true, worth);
  }
}

/// Takes the risky actions out; `best`: not the best by q̂.
void Caution::allow(const ActionView& v, bool best, std::span<double> worth) const {
  const double highest = *std::max_element(v.q.begin(), v.q.end());
  const double least = *std::min_element(v.risk.begin(), v.risk.end());
  const double limit = best ? limit_.now() : std::max(limit_.now(), least);
  for (std::size_t a = 0; a < worth.size(); ++a)
    if (v.risk[a] > limit && !(best && v.q[a] == highest)) worth[a] = -std::numeric_limits<double>::infinity();
}

}  // namespace surefoot
