// SPDX-License-Identifier: GPL-3.0-or-later
// An agent around another: hands everything on. What it adds, it overrides.
#pragma once

#include <memory>
#include <utility>

#include "core/agent.h"

namespace surefoot {

class AgentAround : public Agent {
 public:
  explicit AgentAround(std::unique_ptr<Agent> inner) : inner_(std::move(inner)) {}

  void declare(Fields& f) override { inner_->declare(f); }
  void advance(const LifeTime& time) override { inner_->advance(time); }
  bool everyStep() const override { return inner_->everyStep(); }
  void setPolicy(const Policy& policy) override { inner_->setPolicy(policy); }
  void setGuardian(const Guardian* guardian) override { inner_->setGuardian(guardian); }
  void showRisk(std::span<const double> risk) override { inner_->showRisk(risk); }

  Action start(std::span<const double> state, Random& random) override { return inner_->start(state, random); }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    return inner_->step(outcome, state, random);
  }
  void end(const Outcome& outcome) override { inner_->end(outcome); }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    return inner_->truncate(outcome, state, random);
  }
  void abandon() override { inner_->abandon(); }

  const ActionValueFunction& values() const override { return inner_->values(); }
  void eligibility(std::vector<Eligibility>& z) const override { inner_->eligibility(z); }
  std::vector<NamedStep> lastSteps() const override { return inner_->lastSteps(); }
  bool diverged() const override { return inner_->diverged(); }
  std::int64_t statesOutside() const override { return inner_->statesOutside(); }
  std::int64_t explored() const override { return inner_->explored(); }
  std::int64_t guarded() const override { return inner_->guarded(); }
  const Calibration* calibration() const override { return inner_->calibration(); }
  std::optional<double> priceOfFall() const override { return inner_->priceOfFall(); }

  Json layouts() const override { return inner_->layouts(); }
  void fit(std::span<const double> state, Layer layer, std::span<const double> q, double share,
           double visits) override {
    inner_->fit(state, layer, q, share, visits);
  }
  void transferValues(Archive& archive) override { inner_->transferValues(archive); }
  void transferLearning(Archive& archive) override { inner_->transferLearning(archive); }

 protected:
  Agent& inner() { return *inner_; }
  const Agent& inner() const { return *inner_; }

 private:
  std::unique_ptr<Agent> inner_;
};

}  // namespace surefoot
