// SPDX-License-Identifier: GPL-3.0-or-later
// An agent that does not learn: the environment's own, hand-made controller acts (kHandMade). Learners are compared
// with it.
#pragma once

#include "core/agent.h"

namespace surefoot {

class Scripted final : public Agent {
 public:
  explicit Scripted(int actions) : values_(actions) {}

  void declare(Fields&) override {}
  Action start(std::span<const double>, Random&) override { return kHandMade; }
  Action step(const Outcome&, std::span<const double>, Random&) override { return kHandMade; }
  void end(const Outcome&) override {}
  Action truncate(const Outcome&, std::span<const double>, Random&) override { return kHandMade; }
  void abandon() override {}
  const ActionValueFunction& values() const override { return values_; }
  void eligibility(std::vector<Eligibility>& z) const override { z.clear(); }
  std::vector<NamedStep> lastSteps() const override { return {}; }
  bool diverged() const override { return false; }
  std::int64_t statesOutside() const override { return 0; }
  Json layouts() const override { return Json::object(); }
  void fit(std::span<const double>, Layer, std::span<const double>, double, double) override {}
  void transferValues(Archive&) override {}
  void transferLearning(Archive&) override {}

 private:
  /// It expects nothing.
  class Nothing final : public ActionValueFunction {
   public:
    explicit Nothing(int actions) : actions_(actions) {}
    int actions() const override { return actions_; }
    void evaluate(std::span<const double>, Layer, std::span<double> q) const override { zero(q); }
    double visits(std::span<const double>) const override { return 0.0; }
    double familiarity(std::span<const double>) const override { return 0.0; }
    void average(std::span<const Eligibility>, std::span<const double>, std::span<double> out) const override {
      zero(out);
    }
    std::vector<std::vector<double>> tables() const override { return {}; }
    std::vector<MemoryUse> memoryUse() const override { return {}; }
    std::size_t bytes() const override { return 0; }
    std::unique_ptr<ActionValueFunction> clone() const override { return std::make_unique<Nothing>(*this); }
    void assign(const ActionValueFunction&) override {}

   private:
    static void zero(std::span<double> values) {
      for (double& value : values) value = 0.0;
    }
    int actions_;
  };

  Nothing values_;
};

}  // namespace surefoot
