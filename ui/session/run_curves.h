// SPDX-License-Identifier: GPL-3.0-or-later
// The learning curves that the charts draw: the life that runs, and the last few before it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/life/learning_curve.h"
#include "core/life/life.h"

namespace surefoot {

/// A piece of a curve learned under one policy.
struct CurvePiece {
  std::string policy;
  std::vector<CurvePoint> points;
  std::int64_t from = 0;  ///< steps of the life at which it begins
};

struct RunCurve {
  std::string agent;
  int number = 1;       ///< of the life since the window was opened
  int environment = 0;  ///< counts those that the window was in
  std::vector<CurvePoint> points;
  /// The same points, cut where the policy changed: there, between two of them, one piece ends and the next begins.
  std::vector<CurvePiece> pieces;
  std::int64_t fallsBefore = 0;  ///< those of which the curve does not know when they were
  std::string began{};           ///< how its life began: "pre-learned (scenario 2)"; empty: with an empty table
  /// In force at its end.
  std::string policy() const { return pieces.empty() ? "" : pieces.back().policy; }
};

class RunCurves {
 public:
  static constexpr std::size_t kMostEarlier = 5;

  /// How the life that runs began, as RunCurve::began.
  void setBegan(std::string began) { began_ = std::move(began); }
  /// The points of the life that runs, its learning rule, the policy of its last episode, and what was changed
  /// meanwhile.
  void update(const std::string& agent, const std::string& policy, const std::vector<CurvePoint>& points,
              const std::vector<Change>& changes);
  /// The life that ran becomes an earlier one; one too short to say anything is forgotten.
  void archive();
  /// An earlier life runs again: its curve is the live one. One that is not among the earlier ones has no points yet.
  void bringBack(int number);
  /// In another environment there is nothing to compare with.
  void forget();
  /// Takes earlier lives out by their numbers, and gives them back; those of another environment do not come back.
  std::vector<RunCurve> remove(const std::vector<int>& numbers);
  void putBack(const std::vector<RunCurve>& curves);

  const RunCurve& live() const { return live_; }
  const std::vector<RunCurve>& earlier() const { return earlier_; }

 private:
  std::string began_;
  int newest_ = 1;  // number of a life
  RunCurve live_;
  std::vector<RunCurve> earlier_;
  int environment_ = 0;  // counts them
};

}  // namespace surefoot
