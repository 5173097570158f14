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

#include <memory>
#include <utility>

#include "core/agent.h"
#include "core/agents/risk_values.h"
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
class RiskAgent final : public Agent {
 public:
  RiskAgent(std::unique_ptr<Agent> agent, Estimate<F> risk, const RiskSettings& settings)
      : agent_(std::move(agent)),
        estimate_(std::move(risk)),
        settings_(settings),
        values_(agent_->values(), estimate_.values()),
        next_(static_cast<std::size_t>(values_.actions())) {
    agent_->showRisk(next_);
  }
  RiskAgent(const RiskAgent&) = delete;  // values_ looks at the members

  void declare(Fields& f) override {
    agent_->declare(f);
    f.under("risk.", "ρ", [&](Fields& g) { estimate_.settings().declare(g); });
  }
  void advance(const LifeTime& time) override {
    agent_->advance(time);
    estimate_.settings().stepSize.advance(time);
  }
  bool everyStep() const override { return agent_->everyStep() || estimate_.settings().stepSize.everyStep(); }
  void setPolicy(const Policy& policy) override { agent_->setPolicy(policy); }

  Action start(std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    estimate_.go();
    return a_ = agent_->start(state, random);
  }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    const Action next = agent_->step(outcome, state, random);
    learn(outcome, next_[static_cast<std::size_t>(next)]);
    estimate_.go();
    return a_ = next;
  }
  void end(const Outcome& outcome) override {
    agent_->end(outcome);
    learn(outcome, 0.0);
    estimate_.clearTrace();
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    estimate_.arrive(state, next_);
    const Action next = agent_->truncate(outcome, state, random);
    learn(outcome, next_[static_cast<std::size_t>(next)]);
    estimate_.clearTrace();
    return next;
  }
  void abandon() override {
    agent_->abandon();
    estimate_.clearTrace();
  }

  const ActionValueFunction& values() const override { return values_; }
  void eligibility(std::vector<Eligibility>& z) const override { agent_->eligibility(z); }
  std::vector<NamedStep> lastSteps() const override {
    std::vector<NamedStep> steps = agent_->lastSteps();
    steps.push_back(estimate_.lastStep("risk"));
    return steps;
  }
  bool diverged() const override { return agent_->diverged() || estimate_.diverged(); }
  std::int64_t statesOutside() const override { return agent_->statesOutside(); }
  std::int64_t explored() const override { return agent_->explored(); }

  Json layouts() const override {
    Json layouts = agent_->layouts();
    layouts["risk"] = estimate_.values().features().layout();
    return layouts;
  }
  void fit(std::span<const double> state, Layer layer, std::span<const double> q, double share,
           double visits) override {
    if (layer == Layer::Risk)
      estimate_.values().fit(state, q, share, visits);
    else
      agent_->fit(state, layer, q, share, visits);
  }
  void transferValues(Archive& archive) override {
    agent_->transferValues(archive);
    archive.under("risk.", [&] { estimate_.values().transfer(archive); });
  }
  void transferLearning(Archive& archive) override {
    agent_->transferLearning(archive);
    archive.under("risk.", [&] {
      archive.value("action", a_, 0, values_.actions() - 1);
      estimate_.transferLearning(archive);
    });
  }

 private:
  void learn(const Outcome& outcome, double next) {
    const bool fell = outcome.event == Event::Fall;
    const double gamma = settings_.discount;
    estimate_.learn(a_, fell ? 1.0 : 0.0, fell ? 0.0 : gamma * next, gamma, TraceSettings{});
    if (fell) estimate_.clearTrace();
  }

  std::unique_ptr<Agent> agent_;
  Estimate<F> estimate_;
  RiskSettings settings_;
  RiskValues<F> values_;
  std::vector<double> next_;  ///< ρ(S′, ·)
  Action a_ = 0;
};

}  // namespace surefoot
