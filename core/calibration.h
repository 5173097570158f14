// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the risk of a fall holds: what ρ said of the last 10,000 actions, and what came. After an episode each of its
// actions counts γ_ρᵏ if the episode fell k steps later, else 0. Behind a time limit nobody knows: what ρ says of the
// state where the episode would have gone on counts, so many steps later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/files/archive.h"

namespace surefoot {

/// Used by one thread; copies are values. None of its calls but report() takes memory.
class Calibration {
 public:
  static constexpr std::size_t kSteps = 10'000;

  enum class Verdict { Holds, Errs, Unclear };

  /// What was said in a range of ρ, and what came.
  struct Bin {
    double low = 0.0, high = 0.0;  ///< ρ said, in [low, high); the last bin has no end
    std::int64_t count = 0;
    double said = 0.0, fell = 0.0;  ///< means
  };
  struct Report {
    Bin all;                ///< everything
    std::vector<Bin> bins;  ///< those with an action
    /// Half of the 95 % interval of said − fell, from the episodes: actions of one episode share their fate.
    double halfWidth = 0.0;
    /// Σ abs(said − fell)·count/all: the expected calibration error (Guo et al. 2017, arXiv 1706.04599).
    double error() const;
    /// Errs: what was said and what came differ by more than half a per cent, and by more than chance would make them.
    /// Unclear: they do not, but chance would make a difference of half of what was said or came.
    Verdict verdict() const;
  };

  explicit Calibration(double discount) : discount_(discount), said_(kSteps), came_(kSteps), last_(kSteps) {}

  /// ρ(S, A) of the action that was just carried out, before anything is learned from it. Hot.
  void say(double risk) {
    said_[next_] = static_cast<float>(risk);
    last_[next_] = 0;
    next_ = next_ + 1 == kSteps ? 0 : next_ + 1;
    if (open_ < kSteps) ++open_;
    if (closed_ + open_ > kSteps) closed_ = kSteps - open_;
  }
  /// What the last action came to: 1 a fall, 0 none, between them what is expected behind a time limit; those since the
  /// last end before it came to γ_ρᵏ of that.
  void end(double came);
  /// Nothing is known of the actions since the last end.
  void abandon();

  Report report() const;
  void transfer(Archive& archive);

 private:
  double discount_;
  std::vector<float> said_, came_;  // a ring
  std::vector<std::uint8_t> last_;  // whether it was the last action before an end
  std::size_t next_ = 0;            // where the next action goes
  std::size_t open_ = 0;            // the newest actions, of an episode that goes on
  std::size_t closed_ = 0;          // those before, of which it is known what came
};

}  // namespace surefoot
