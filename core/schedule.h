// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter that may change while a life goes on: exploration that fades, a step size that shrinks. With t episodes
// or steps of the life behind it,
//
//   constant     v(t) = start
//   linear       v(t) = start + (end − start)·min(t/T, 1)
//   exponential  v(t) = end + (start − end)·2^(−t/T)
//   rule         v(t) = what the rule of thumb says by then (a threshold only); start as long as it says nothing
//
// T is the time to the end, or the half-life. Values; used by one thread at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "core/parameters.h"

namespace surefoot {

/// How far a life has come.
struct LifeTime {
  std::int64_t episodes = 0, steps = 0;  ///< finished
  std::optional<double> rule{};          ///< the threshold by the rule of thumb (rule_of_thumb.h)
};

class Scheduled {
 public:
  Scheduled(double start) : start_(start), end_(start) {}

  /// Declares the parameter itself, and behind it `key`_schedule, _end, _over and _per. `byRule`: it may follow the
  /// rule of thumb.
  void declare(Fields& f, const Parameter& parameter, bool byRule = false);
  /// The value now. Hot.
  double now() const { return kind_ == Kind::Constant ? start_ : now_; }
  /// Time goes on.
  void advance(const LifeTime& time);
  /// Whether it changes with every step; otherwise advance() between two episodes is enough.
  bool everyStep() const { return kind_ != Kind::Constant && per_ == Per::Steps; }

 private:
  enum class Kind : int { Constant, Linear, Exponential, Rule };
  enum class Per : int { Episodes, Steps };

  double start_, end_, over_ = 1000.0, now_ = 0.0;
  Kind kind_ = Kind::Constant;
  Per per_ = Per::Episodes;
};

/// A component with parameters that may follow a schedule.
class Scheduling : public Configurable {
 public:
  /// Time goes on: called between two episodes, or between two steps if everyStep().
  virtual void advance(const LifeTime&) {}
  virtual bool everyStep() const { return false; }
};

}  // namespace surefoot
