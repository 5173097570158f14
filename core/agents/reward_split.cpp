// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/agents/reward_split.h"

#include <algorithm>

namespace surefoot {

void RewardSplit::declare(Fields& f) {
  f.choice(by_, {.key = "by",
                 .title = "Split",
                 .when = When::Now,
                 .group = Group::Learning,
                 .help = "Each term of the reward goes its own way, or their sum goes by its sign.",
                 .origin = "thesis, section 6.1.2",
                 .choices = {"terms", "sum"},
                 .order = 3});
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    std::string title = "Split of " + terms_[i];
    f.choice(shares_[i], {.key = terms_[i],
                          .title = title,
                          .when = When::Now,
                          .group = Group::Learning,
                          .help = "Which estimate learns from this reward: by its sign, Q⁺, Q⁻ or both.",
                          .origin = "thesis, section 6.1.2",
                          .choices = {"sign", "positive", "negative", "both"},
                          .order = 3});
  }
}

RewardSplit::Parts RewardSplit::operator()(const Outcome& outcome) const {
  if (by_ == By::Sum) return {std::max(outcome.reward, 0.0), std::min(outcome.reward, 0.0)};
  Parts parts;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const double r = outcome.terms[i];
    const Share share = shares_[i];
    if (share == Share::Positive || share == Share::Both || (share == Share::Sign && r > 0)) parts.positive += r;
    if (share == Share::Negative || share == Share::Both || (share == Share::Sign && r < 0)) parts.negative += r;
  }
  return parts;
}

}  // namespace surefoot
