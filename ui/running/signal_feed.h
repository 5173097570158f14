// SPDX-License-Identifier: GPL-3.0-or-later
// The signals of the world that is shown, written down step by step for whoever looks at them. The first moment of an
// episode in the learner's world is not among them.
#pragma once

#include <cstdint>
#include <span>

#include "core/live/snapshot.h"
#include "core/policy.h"
#include "core/signals/signal_table.h"

namespace surefoot {

class SignalFeed {
 public:
  static constexpr double kKept = 300.0;  ///< [s]

  /// Another world is shown, or another learner in it: all rows go.
  void begin(const Environment& environment, bool hasRisk, double discount);
  /// Nobody looks any more.
  void end();
  bool on() const { return on_; }
  bool hasRisk() const { return hasRisk_; }

  /// The moment before an action, in a world of the window's own, and what it brought.
  void before(const MomentSeen& now, std::span<const double> pi);
  void after(const Outcome& outcome);
  /// What the learner did since the snapshot before, and its present moment.
  void see(const Snapshot& now, const Policy& policy);

  const SignalTable& table() const { return table_; }
  /// The number of the first row that is kept, and of the last; last() < first(): there is none.
  std::int64_t first() const { return first_; }
  std::int64_t last() const { return first_ + static_cast<std::int64_t>(table_.rows()) - 1; }

 private:
  void add(const MomentSeen& moment, std::int64_t steps, std::int64_t episode, std::span<const double> pi);
  std::span<const double> piOf(const MomentSeen& moment, const Policy& policy);
  void trim();

  SignalTable table_;
  std::int64_t first_ = 0;
  double stepTime_ = 1.0, discount_ = 1.0;
  bool on_ = false, hasRisk_ = false;
  std::int64_t steps_ = -1, episode_ = 1;  ///< of the learner's world at the last row; of a world of one's own
  std::int64_t lived_ = 0;                 ///< steps of a world of one's own
  bool tentative_ = false;                 ///< the last row is a moment whose step is to come
  std::vector<double> pi_;
};

}  // namespace surefoot
