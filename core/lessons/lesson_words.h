// SPDX-License-Identifier: GPL-3.0-or-later
// The quantities that the conditions of a lesson are about:
//
//   episodes falls successes steps minutes average_reward   of the life; before.falls … of the life before it
//   policy.epsilon …                                        every parameter of the life, by its key
//   alpha …                                                 every state variable, by its key
//   q("0.75")  probability("0.75")                          of an action, in the state of this moment
//   visits                                                  of that state
//   observed(2)  predicted(2)                               what step 2 came to, and what was said beforehand
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
    Visits,
    Parameter,
    State,
    ActionValue,
    Probability,
    Observed,
    Predicted
  };
  Kind kind = Kind::Episodes;
  bool before = false;    ///< of the life before
  std::string key{};      ///< of a parameter
  std::size_t index = 0;  ///< of a state variable, an action or a step (from 0)

  bool operator==(const LessonQuantity&) const = default;
};

/// A lesson's quantities in the order in which its conditions name them first: the places of their values.
class LessonWords : public Vocabulary {
 public:
  LessonWords(const Task& task, const Parameters& parameters) : task_(task), parameters_(parameters) {}

  /// The conditions that come next are those of the last of these steps: they can name what a step up to it predicted
  /// and observed. `predicts`: of each step, whether it predicts anything.
  void beginStep(std::vector<bool> predicts) { predicts_ = std::move(predicts); }

  Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const override;
  std::vector<std::string> names() const override;

  const std::vector<LessonQuantity>& quantities() const { return quantities_; }

 private:
  Result<Quantity> withArgument(std::string_view name, std::string_view argument) const;
  Quantity placed(LessonQuantity quantity, double low = -kInfinity, double high = kInfinity) const;

  const Task& task_;
  const Parameters& parameters_;
  std::vector<bool> predicts_;
  mutable std::vector<LessonQuantity> quantities_;
};

}  // namespace surefoot
