// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/caution.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace surefoot {

namespace {
constexpr const char* kRules[] = {"off", "weight", "filter", "explore", "losses"};
}

const char* nameOf(CautionRule rule) {
  return kRules[static_cast<int>(rule)];
}

Status Caution::check(bool hasRisk, bool split) const {
  if (rule_ == CautionRule::Off || (rule_ == CautionRule::Losses ? split : hasRisk)) return Done{};
  return Error{fmt::format("policy.risk = {}: it needs {}.", nameOf(rule_),
                           rule_ == CautionRule::Losses ? "expected losses apart, as the agent sarsa-2q learns them"
                                                        : "the risk of a fall, which is learned with risk.learn = on")};
}

void Caution::declare(Fields& f) {
  f.choice(rule_, {.key = "risk",
                   .title = "Caution",
                   .when = When::Now,
                   .group = Group::Policy,
                   .help = "What the policy does with the risk of a fall, or with the losses of Sarsa_2Q.",
                   .origin = "ours: off, as in the thesis",
                   .choices = {std::begin(kRules), std::end(kRules)},
                   .order = 3});
  const auto declare = [&](Scheduled& value, Parameter p) {
    p.when = When::Now, p.group = Group::Policy, p.order = 3, p.needs = "risk";
    value.declare(f, p);
  };
  declare(weight_, {.key = "risk_weight",
                    .title = "Weight of risk",
                    .symbol = "w",
                    .low = 0.0,
                    .high = 1e6,
                    .sliderLow = 0.0,
                    .sliderHigh = 6400.0,
                    .help = "Caution = weight: a certain fall costs an action so much of its value.",
                    .origin = "ours: in place of a fall reward of -3000"});
  declare(limit_, {.key = "risk_limit",
                   .title = "Limit of risk",
                   .low = 0.0,
                   .high = 1.0,
                   .sliderLow = 0.0,
                   .sliderHigh = 0.2,
                   .help = "Caution = filter or explore: actions that fall with a higher probability are left out.",
                   .origin = "ours"});
  declare(factor_, {.key = "losses_factor",
                    .title = "Factor of losses",
                    .symbol = "k",
                    .low = 0.0,
                    .high = 1e4,
                    .sliderLow = 0.0,
                    .sliderHigh = 64.0,
                    .help = "Caution = losses: expected losses count so many times.",
                    .origin = "ours: 1 is Sarsa_2Q of the thesis"});
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
