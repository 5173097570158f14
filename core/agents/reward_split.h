// SPDX-License-Identifier: GPL-3.0-or-later
// How Sarsa_2Q divides the reward among its two estimates (thesis, section 6.1.2; sections 6.5 and 7 for the other
// ways): r = r⁺ + r⁻, each named term by its sign, or assigned to Q⁺, to Q⁻ or to both; or the whole sum by its sign.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/basics/types.h"
#include "core/parameters.h"

namespace surefoot {

class RewardSplit {
 public:
  enum class Share : int { Sign, Positive, Negative, Both };
  enum class By : int { Terms, Sum };
  struct Parts {
    double positive = 0.0, negative = 0.0;
  };

  explicit RewardSplit(std::vector<std::string> terms) : terms_(std::move(terms)) {}

  void declare(Fields& f);
  /// r⁺ and r⁻ of an outcome. Hot.
  Parts operator()(const Outcome& outcome) const;

 private:
  std::vector<std::string> terms_;
  std::array<Share, kMaxRewardTerms> shares_{};
  By by_ = By::Terms;
};

}  // namespace surefoot
