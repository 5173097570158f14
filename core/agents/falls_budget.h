// SPDX-License-Identifier: GPL-3.0-or-later
// A falls budget: for people who would have to guess the reward of a fall. Around any agent: every fall costs Λ more
// than the environment says, and Λ finds its own size (after Tessler, Mankowitz & Mannor 2018, arXiv 1805.11074):
//
//   R′ = R − Λ·[fall],   Λ ← max(0, Λ + η (falls of the episode − d))   after every episode
//
// d is the budget [falls an episode], η the rate [reward]. What it finds is a larger penalty; the log keeps the
// environment's own rewards.
#pragma once

#include <optional>

#include "core/agents/agent_around.h"

namespace surefoot {

enum class Budgeting : int { Off, On };

struct BudgetSettings {
  Budgeting kind = Budgeting::Off;
  double budget = 0.1;  ///< d
  double rate = 10.0;   ///< η
  void declare(Fields& f);
  /// What may change while a life goes on: d and η.
  void declareLive(Fields& f);
};

class FallsBudget final : public AgentAround {
 public:
  /// `term` is the place of the price among the named terms of an outcome.
  FallsBudget(std::unique_ptr<Agent> agent, const BudgetSettings& settings, std::size_t term)
      : AgentAround(std::move(agent)),
        settings_(settings),
        term_(term) {}

  void declare(Fields& f) override {
    inner().declare(f);
    settings_.declareLive(f);
  }
  Action step(const Outcome& outcome, std::span<const double> state, Random& random) override {
    return inner().step(priced(outcome), state, random);
  }
  void end(const Outcome& outcome) override {
    inner().end(priced(outcome));
    balance();
  }
  Action truncate(const Outcome& outcome, std::span<const double> state, Random& random) override {
    const Action next = inner().truncate(priced(outcome), state, random);
    balance();
    return next;
  }
  void abandon() override {
    inner().abandon();
    falls_ = 0;
  }
  std::optional<double> priceOfFall() const override { return price_; }
  void transferLearning(Archive& archive) override;

 private:
  Outcome priced(Outcome outcome) {
    if (outcome.event != Event::Fall) return outcome;
    ++falls_;
    outcome.reward -= price_;
    outcome.terms[term_] -= price_;
    return outcome;
  }
  /// An episode is over.
  void balance() {
    price_ = std::max(0.0, price_ + settings_.rate * (static_cast<double>(falls_) - settings_.budget));
    falls_ = 0;
  }

  BudgetSettings settings_;
  std::size_t term_;
  double price_ = 0.0;      ///< Λ
  std::int64_t falls_ = 0;  ///< of this episode
};

}  // namespace surefoot
