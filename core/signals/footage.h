// SPDX-License-Identifier: GPL-3.0-or-later
// What a film shows: poses of an environment at equal distances of time. Each is the newest at its moment; nothing is
// made up between two steps.
#pragma once

#include <cstdint>
#include <vector>

#include "core/environment.h"

namespace surefoot {

/// Pictures a second of every film.
inline constexpr double kFilmRate = 30.0;
/// The longest film: ten minutes.
inline constexpr std::int64_t kMostFilmFrames = 18'000;
/// The time of a step in a task without a clock [s], as the window shows it.
inline constexpr double kUnclockedStep = 0.05;

struct Footage {
  std::vector<std::vector<double>> poses;
  std::vector<std::uint8_t> falls;  ///< 1: it fell a moment ago; one a pose
  std::vector<std::int64_t> rows;   ///< of the signals of that moment in their table, −1: there are none; one a pose
  double rate = kFilmRate;          ///< poses a second

  double seconds() const { return static_cast<double>(poses.size()) / rate; }
};

/// How many pictures a film of this length [s] has: one at every multiple of 1/30 s before its end, at least one.
std::int64_t filmFrames(double seconds);

/// A part of a footage for a film, from one time to another [s], `speed` times as fast as it was.
Footage cut(const Footage& footage, double from, double to, double speed = 1.0);

/// How long a fallen body is seen, in the window as in a film, while the next episode has begun already [s].
inline constexpr double kFallShown = 0.2;

/// Takes a pose at every multiple of 1/30 s. After a fall the fallen body is seen for kFallShown, as in the window,
/// while the next episode has begun already. Looking changes nothing.
class FootageTaker {
 public:
  /// The world at a moment [s], not before the one before; `fell`: by a fall that ended the step before; `row`: as in
  /// Footage.
  void look(const Environment& environment, double time, bool fell, std::int64_t row = -1);
  /// Everything up to the end [s], and of a fall at the end what is to be seen of it.
  Footage finish(double end);

 private:
  void take(double until);

  Footage footage_;
  std::vector<double> pose_, fallen_;
  double fallenUntil_ = -1.0;  // [s]
  std::int64_t row_ = -1;
};

}  // namespace surefoot
