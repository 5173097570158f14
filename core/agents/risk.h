// SPDX-License-Identifier: GPL-3.0-or-later
// The risk of a fall, learned beside any agent: ρ(s, a) is the probability, discounted by γ_ρ, that the episode comes
// to a fall if a is taken and the policy in force goes on (Geibel & Wysotzki 2005, JAIR 24, doi 10.1613/jair.1666).
//
//   δ_ρ = [1 after a fall, 0 after another end, else γ_ρ ρ(S′, A′)] − ρ(S, A),   w_ρ ← w_ρ + α_ρ δ_ρ z_ρ
//
// on features of its own. A fall ends what ρ looks at, also where the episode goes on (the cliff); after a time limit
// ρ(S′, A′) is estimated. Learning it draws no random number and touches no weight of q̂. What is done with it is the
// policy's (core/caution.h): the agent inside is shown ρ(S′, ·) before it chooses A′.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/agents/agent_around.h"
#include "core/agents/risk_values.h"
#include "core/calibration.h"
#include "core/values/estimate.h"

namespace surefoot {

enum class RiskLearning : int { Off, On };

struct RiskSettings {
  RiskLearning learn = RiskLearning::Off;
  double discount = 1.0;  ///< γ_ρ
  double initial = 0.0;   ///< ρ before anything is known
  void declare(Fields& f);
};

template <FeatureMap F>
class RiskAgent final : public AgentAround {
 public:
  RiskAgent(std::unique_ptr<Agent> agent, Estimate<F> risk, const RiskSettings& settings)
      : AgentAround(std::move(agent)),
        estimate_(std::move(risk)),
        settings_(settings),
        values_(inner().values(), estimate_.values()),
        calibration_(settings.discount),
        next_(static_cast<std::size_t>(values_.actions())) {
    inner().showRisk(next_);
  }
  RiskAgent(const RiskAgent&) = delete;  // values_ looks at the members

  void declare(Fields& f) override {
    inner().declare(f);
    f.under("risk.", "ρ", [&](Fields& g) { estimate_.settings().declare(g); });
  }
  void advance(const LifeTime& time) override {
    inner().advance(time);
    estimate_.settings().stepSize.advance(time);
  }
  bool everyStep() const override { return inner().everyStep() || estimate_.settings().stepSize.everyStep(); }

  Action start(std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    estimate_.go();
    return a_ = inner().start(state, random);
  }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    const Action next = inner().step(outcome, state, random);
    learn(outcome, next_[static_cast<std::size_t>(next)]);
    estimate_.go();
    return a_ = next;
  }
  void end(const Outcome& outcome) override {
    inner().end(outcome);
    learn(outcome, 0.0);
    close(0.0);
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    const Action next = inner().truncate(outcome, state, random);
    const double goesOn = next_[static_cast<std::size_t>(next)];
    learn(outcome, goesOn);
    close(settings_.discount * std::clamp(goesOn, 0.0, 1.0));
    return next;
  }
  void abandon() override {
    inner().abandon();
    estimate_.clearTrace();
    calibration_.abandon();
  }

  const ActionValueFunction& values() const override { return values_; }
  std::vector<NamedStep> lastSteps() const override {
    std::vector<NamedStep> steps = inner().lastSteps();
    steps.push_back(estimate_.lastStep("risk"));
    return steps;
  }
  bool diverged() const override { return inner().diverged() || estimate_.diverged(); }
  const Calibration* calibration() const override { return &calibration_; }

  Json layouts() const override {
    Json layouts = inner().layouts();
    layouts["risk"] = estimate_.values().features().layout();
    return layouts;
  }
  void fit(std::span<const double> state, Layer layer, std::span<const double> q, double share,
           double visits) override {
    if (layer == Layer::Risk)
      estimate_.values().fit(state, q, share, visits);
    else
      inner().fit(state, layer, q, share, visits);
  }
  void transferValues(Archive& archive) override {
    inner().transferValues(archive);
    archive.under("risk.", [&] { estimate_.values().transfer(archive); });
  }
  void transferLearning(Archive& archive) override {
    inner().transferLearning(archive);
    archive.under("risk.", [&] {
      archive.value("action", a_, 0, values_.actions() - 1);
      estimate_.transferLearning(archive);
      calibration_.transfer(archive);
    });
  }

 private:
  void learn(const Outcome& outcome, double next) {
    const bool fell = outcome.event == Event::Fall;
    const double gamma = settings_.discount;
    estimate_.learn(a_, fell ? 1.0 : 0.0, fell ? 0.0 : gamma * next, gamma, TraceSettings{});
    calibration_.say(estimate_.last().before);
    if (!fell) return;
    estimate_.clearTrace();
    calibration_.end(1.0);
  }
  /// The episode is over; nothing is open any more if it ended in a fall.
  void close(double came) {
    estimate_.clearTrace();
    calibration_.end(came);
  }

  Estimate<F> estimate_;
  RiskSettings settings_;
  RiskValues<F> values_;
  Calibration calibration_;
  std::vector<double> next_;  ///< ρ(S′, ·)
  Action a_ = 0;
};

}  // namespace surefoot
