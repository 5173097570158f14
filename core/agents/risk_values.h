// SPDX-License-Identifier: GPL-3.0-or-later
// q̂ of an agent with ρ beside it, seen from outside: Layer::Risk is ρ, all else is the agent's.
#pragma once

#include <memory>

#include "core/basics/expects.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

template <FeatureMap F>
class RiskValues final : public ActionValueFunction {
 public:
  /// Refers to two functions that must outlive it; a clone has its own.
  RiskValues(const ActionValueFunction& q, const LinearActionValue<F>& risk) : q_(&q), risk_(&risk) {}

  int actions() const override { return q_->actions(); }
  void evaluate(std::span<const double> state, Layer layer, std::span<double> q) const override {
    if (layer == Layer::Risk) return risk_->evaluate(state, layer, q);
    q_->evaluate(state, layer, q);
  }
  bool split() const override { return q_->split(); }
  bool hasRisk() const override { return true; }
  double visits(std::span<const double> state) const override { return q_->visits(state); }
  double familiarity(std::span<const double> state) const override { return q_->familiarity(state); }
  void average(std::span<const Eligibility> z, std::span<const double> state, std::span<double> out) const override {
    q_->average(z, state, out);
  }
  /// Of q̂ alone: what ρ knows is no part of what the agent has learned.
  std::vector<std::vector<double>> tables() const override { return q_->tables(); }
  std::vector<MemoryUse> memoryUse() const override {
    auto use = q_->memoryUse();
    use.push_back(risk_->memoryUse().front());
    return use;
  }
  std::size_t bytes() const override { return q_->bytes() + risk_->bytes(); }
  std::unique_ptr<ActionValueFunction> clone() const override {
    auto copy = std::make_unique<RiskValues>(*q_, *risk_);
    copy->ownQ_ = q_->clone();
    copy->ownRisk_ = risk_->copy();
    copy->q_ = copy->ownQ_.get();
    copy->risk_ = copy->ownRisk_.get();
    return copy;
  }
  void assign(const ActionValueFunction& other) override {
    const auto& same = dynamic_cast<const RiskValues&>(other);
    expects(ownQ_ && ownRisk_, "only a clone has memory of its own");
    ownQ_->assign(*same.q_);
    ownRisk_->assign(*same.risk_);
  }

 private:
  const ActionValueFunction* q_;
  const LinearActionValue<F>* risk_;
  std::unique_ptr<ActionValueFunction> ownQ_;
  std::unique_ptr<LinearActionValue<F>> ownRisk_;
};

}  // namespace surefoot
