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
  std::int64_t from = 0;  ///< the step of the life at which the piece begins
};

struct RunCurve {
  std::string agent;
  int number = 1;       ///< number of the life, counted since the environment was chosen
  int environment = 0;  ///< number of the environment, counted since the window was opened
  std::vector<CurvePoint> points;
  /// The same points, cut where the policy changed: there, between two of them, one piece ends and the next begins.
  std::vector<CurvePiece> pieces;
  std::int64_t fallsBefore = 0;  ///< falls before the curve begins; their times are not known
  std::string began{};           ///< how its life began: "pre-learned (scenario 2)"; empty: with an empty table
  /// The policy in force at the end of the curve.
  std::string policy() const { return pieces.empty() ? "" : pieces.back().policy; }
};

class RunCurves {
 public:
  static constexpr std::size_t kMostEarlier = 5;

  /// How the life that runs began, as RunCurve::began.
  void setBegan(std::string began) { began_ = std::move(began); }
  /// Points of the life that runs that its own curve lacks, because they were seen earlier: those before its first.
  void setSeenBefore(std::vector<CurvePoint> points) { before_ = std::move(points); }
  /// The points of the life that runs, its learning rule, the policy of its last episode, and its changes
  /// so far.
  void update(const std::string& agent, const std::string& policy, const std::vector<CurvePoint>& points,
              const std::vector<Change>& changes);
  /// The live curve becomes an earlier one; a curve that is too short to be of use is dropped.
  void archive();
  /// An earlier life runs again: its curve is the live one. If it is not an earlier one, it has no points yet.
  void bringBack(int number);
  /// In another environment there is nothing to compare with.
  void forget();
  /// Removes earlier curves by their numbers, and returns them; putBack() ignores curves of another environment.
  std::vector<RunCurve> remove(const std::vector<int>& numbers);
  void putBack(const std::vector<RunCurve>& curves);

  const RunCurve& live() const { return live_; }
  const std::vector<RunCurve>& earlier() const { return earlier_; }

 private:
  std::string began_;
  std::vector<CurvePoint> before_;
  int newest_ = 1;  // number of the newest life
  RunCurve live_;
  std::vector<RunCurve> earlier_;
  int environment_ = 0;  // number of the present environment
};

}  // namespace surefoot
