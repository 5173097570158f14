// SPDX-License-Identifier: GPL-3.0-or-later
// Q = Q⁺ + Q⁻ (thesis, eq. 6.4), for display: two linear estimates of different resolution as one function.
#pragma once

#include "core/basics/expects.h"
#include "core/values/linear_action_value.h"

namespace surefoot {

template <FeatureMap P, FeatureMap N>
class SplitActionValue final : public ActionValueFunction {
 public:
  /// Refers to two functions that must outlive it; a clone has its own.
  SplitActionValue(const LinearActionValue<P>& positive, const LinearActionValue<N>& negative)
      : positive_(&positive),
        negative_(&negative) {}

  int actions() const override { return positive_->actions(); }
  void evaluate(std::span<const double> state, Layer layer, std::span<double> q) const override {
    if (layer == Layer::Negative) return negative_->evaluate(state, layer, q);
    positive_->evaluate(state, layer, q);
    if (layer == Layer::Positive) return;
    std::vector<double> negative(q.size());
    negative_->evaluate(state, layer, negative);
    for (std::size_t a = 0; a < q.size(); ++a) q[a] += negative[a];
  }
  bool split() const override { return true; }
  double visits(std::span<const double> state) const override {
    return std::max(positive_->visits(state), negative_->visits(state));  // one of them may be confined to a box
  }
  double familiarity(std::span<const double> state) const override {
    return std::max(positive_->familiarity(state), negative_->familiarity(state));
  }
  /// The weights of Q⁺ come first; only their eligibility is shown.
  void average(std::span<const Eligibility> z, std::span<const double> state, std::span<double> out) const override {
    positive_->average(z, state, out);
  }
  std::size_t bytes() const override { return positive_->bytes() + negative_->bytes(); }
  std::vector<std::vector<double>> tables() const override {
    return {positive_->tables().front(), negative_->tables().front()};
  }
  std::vector<MemoryUse> memoryUse() const override {
    return {positive_->memoryUse().front(), negative_->memoryUse().front()};
  }
  std::unique_ptr<ActionValueFunction> clone() const override {
    auto copy = std::make_unique<SplitActionValue>(*positive_, *negative_);
    copy->ownPositive_ = positive_->copy();
    copy->ownNegative_ = negative_->copy();
    copy->positive_ = copy->ownPositive_.get();
    copy->negative_ = copy->ownNegative_.get();
    return copy;
  }
  void assign(const ActionValueFunction& other) override {
    const auto& same = dynamic_cast<const SplitActionValue&>(other);
    expects(ownPositive_ && ownNegative_, "only a clone has memory of its own");
    ownPositive_->assign(*same.positive_);
    ownNegative_->assign(*same.negative_);
  }

 private:
  const LinearActionValue<P>* positive_;
  const LinearActionValue<N>* negative_;
  std::unique_ptr<LinearActionValue<P>> ownPositive_;
  std::unique_ptr<LinearActionValue<N>> ownNegative_;
};

}  // namespace surefoot
