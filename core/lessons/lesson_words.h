// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that the conditions of a lesson are about:
//
//   episodes falls successes steps minutes average_reward exploring pushes
//                                                           of the life; before.falls … of the life before it.
//                                                           exploring: share of the steps whose action was not the
//                                                           best; pushes: by hand, and places it was put into
//   policy.epsilon …                                        every parameter of the life, by its key
//   alpha …                                                 every state variable, by its key
//   q("0.75")  risk("0.75")  probability("0.75")            of an action, in the state of this moment; risk in per
//                                                           cent, of a life that learns it
//   visits                                                  of that state
//   observed(2)  predicted(2)                               what step 2 came to, and what was said beforehand
//   mean("ε 0.05")  least("ε 0.05")  most("ε 0.05")         over the lives of a way, of this step or an earlier one
//   lower("ε 0.05, ε 0.25")  tells("ε 0.05, ε 0.25")        1 if the 95 % interval of the mean difference of the two
//                                                           ways leaves out 0 (lower: and the first is the lower one)
//   replays                                                 falls that were looked at again
//   pointed                                                 the episode of a fall, or the action, that is pointed at
//
// Only what a condition names is ever computed.
#pragma once

#include <string>
#include <vector>

#include "core/environment.h"
#include "core/expression/vocabulary.h"
#include "core/parameters.h"

namespace surefoot {

struct LessonQuantity {
  enum class Kind {
    Episodes,
    Falls,
    Successes,
    Steps,
    Minutes,
    AverageReward,
    Exploring,
    Pushes,  // the last of the counters of a life
    Replays,
    Pointed,
    Mean,
    Least,
    Most,
    Lower,
    Tells,
    Visits,
    Parameter,
    State,
    ActionValue,
    Risk,
    Probability,
    Observed,
    Predicted
  };
  Kind kind = Kind::Episodes;
  bool before = false;    ///< of the life before
  std::string key{};      ///< of a parameter
  std::size_t index = 0;  ///< of a state variable, an action, a step (from 0) or a way of lives
  std::size_t other = 0;  ///< another way

  bool operator==(const LessonQuantity&) const = default;
};
inline constexpr auto kLifeCounters = static_cast<std::size_t>(LessonQuantity::Kind::Pushes) + 1;

/// A lesson's quantities in the order in which its conditions name them first: the places of their values.
class LessonWords : public Vocabulary {
 public:
  LessonWords(const Task& task, const Parameters& parameters) : task_(task), parameters_(parameters) {}

  /// What the conditions that come next may name of the steps up to theirs.
  struct Known {
    std::vector<bool> predicts{}, observes{};  ///< of each step, whether it does
    std::vector<std::string> ways{};           ///< the labels of the ways that are lived
    bool pointing = false;                     ///< a place is pointed at
  };
  Known& known() { return known_; }

  Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const override;
  std::vector<std::string> names() const override;

  const std::vector<LessonQuantity>& quantities() const { return quantities_; }

 private:
  Result<Quantity> ofTwoWays(LessonQuantity::Kind kind, std::string_view argument) const;
  std::optional<std::size_t> wayNamed(std::string_view label) const;
  Result<Quantity> withArgument(std::string_view name, std::string_view argument) const;
  Quantity placed(LessonQuantity quantity, double low = -kInfinity, double high = kInfinity) const;

  const Task& task_;
  const Parameters& parameters_;
  Known known_;
  mutable std::vector<LessonQuantity> quantities_;
};

}  // namespace surefoot
