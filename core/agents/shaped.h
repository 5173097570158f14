// SPDX-License-Identifier: GPL-3.0-or-later
// Reward shaping by a coarse state-value function that is learned alongside (thesis, eq. 6.5 and 6.6, after Grześ &
// Kudenko 2008; potentials: Ng, Harada & Russell 1999). Around any agent: every reward that reaches it is
//
//   R + F(S, S′),   F = γ_v V(S′) − V(S)
//
// with V on features of its own, learned by TD(0): V(S) ← V(S) + α_v [R_v + γ_v V(S′) − V(S)], where R_v is the whole
// reward or only its gains or losses. Both V in F are taken before this update; after a terminal step V(S′) is 0.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "core/agents/agent_around.h"
#include "core/values/estimate.h"

namespace surefoot {

/// Off, or which rewards the potential is learned from.
enum class Shaping : int { Off, All, Losses, Gains };

struct ShapingSettings {
  Shaping kind = Shaping::Off;
  double discount = 0.98;  ///< γ_v
  double stepSize = 0.4;   ///< α_v
  void declare(Fields& f);
};

template <FeatureMap F>
class ShapedAgent final : public AgentAround {
 public:
  /// `term` is the place of F among the named terms of an outcome.
  ShapedAgent(std::unique_ptr<Agent> agent, Estimate<F> potential, const ShapingSettings& settings, std::size_t term)
      : AgentAround(std::move(agent)),
        potential_(std::move(potential)),
        settings_(settings),
        term_(term) {}

  Action start(std::span<const double> state, Random& random) override {
    lookAt(state);
    potential_.go();
    return inner().start(state, random);
  }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Outcome shaped = shape(outcome, lookAt(state));
    potential_.go();
    return inner().step(shaped, state, random);
  }
  void end(const Outcome& outcome) override { inner().end(shape(outcome, 0.0)); }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    return inner().truncate(shape(outcome, lookAt(state)), state, random);
  }

  void abandon() override {
    inner().abandon();
    potential_.clearTrace();
  }

  /// V(s), the potential.
  const ActionValueFunction& potential() const { return potential_.values(); }
  bool diverged() const override { return inner().diverged() || potential_.diverged(); }

  Json layouts() const override {
    Json layouts = inner().layouts();
    layouts["potential"] = potential_.values().features().layout();
    return layouts;
  }
  void transferValues(Archive& archive) override {
    inner().transferValues(archive);
    archive.under("potential.", [&] { potential_.values().transfer(archive); });
  }
  void transferLearning(Archive& archive) override {
    inner().transferLearning(archive);
    archive.under("potential.", [&] { potential_.transferLearning(archive); });
  }

 private:
  double lookAt(std::span<const double> state) {
    double next = 0.0;
    potential_.arrive(state, std::span(&next, 1));
    return next;
  }
  /// Adds F to the outcome, and learns V; `next` is V(S′).
  Outcome shape(Outcome outcome, double next) {
    const double shaping = settings_.discount * next - potential_.value(0);  // F ← γ_v V(S′) − V(S)
    potential_.learn(0, rewardOf(outcome), settings_.discount * next, settings_.discount, TraceSettings{});
    outcome.reward += shaping;
    outcome.terms[term_] += shaping;
    return outcome;
  }
  double rewardOf(const Outcome& outcome) const {
    if (settings_.kind == Shaping::All) return outcome.reward;
    double sum = 0.0;
    for (const double r : outcome.terms)
      if ((settings_.kind == Shaping::Losses) == (r < 0)) sum += r;
    return sum;
  }

  Estimate<F> potential_;
  ShapingSettings settings_;
  std::size_t term_;
};

}  // namespace surefoot
