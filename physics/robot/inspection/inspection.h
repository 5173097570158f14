// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot does by itself and under random actions, held against what its file says of it: ranges, endings,
// energy, joints. Takes some tenths of a second; any thread.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "physics/robot/robot.h"

namespace surefoot {

/// A state variable under random actions.
struct SeenState {
  static constexpr std::size_t kBins = 32;  ///< over the range and a quarter of it to either side
  std::string key, unit;
  double low = 0.0, high = 0.0;          ///< as the file says
  double seenLow = 0.0, seenHigh = 0.0;  ///< as it came
  double outside = 0.0;                  ///< share of steps beyond the range
  std::array<int, kBins> bins{};
  int tiles = 0;  ///< over the range
  /// A range that holds all that was seen, and never less than the file's where that was reached; rounded outwards.
  double proposedLow = 0.0, proposedHigh = 0.0;
};

/// The robot without motors, dampers, springs, friction and contacts, from a start on.
struct PassiveEnergy {
  double seconds = 0.0, begins = 0.0, ends = 0.0;  ///< [s], [J]
  double largestMotion = 0.0;                      ///< the largest kinetic energy [J]
  /// Share of the largest kinetic energy that is lost in a second: what the integrator damps.
  double lossPerSecond() const;
};

struct RobotInspection {
  std::vector<SeenState> states;
  PassiveEnergy passive, halved;  ///< with the file's substeps, and with twice as many
  double jointGap = 0.0;          ///< the largest distance of a joint's two ends under random actions [m]
  double smallestRadius = 0.0;    ///< of what meets something [m]; 0: nothing does
  double scale = 1.0, proposedScale = 1.0;
  std::vector<std::pair<std::string, bool>> joints;  ///< whether the joint is soft
  std::vector<std::pair<std::string, int>> endings;  ///< how often each came; the step limit last
  double meanSteps = 0.0;                            ///< of the episodes
  double tiles = 0.0;                                ///< of a dense table of all tilings and actions
  std::int64_t flewApart = 0;
  std::vector<Complaint> warnings;
};

/// Of a robot that checkRobot() finds nothing wrong with.
RobotInspection inspectRobot(const std::shared_ptr<const RobotSpec>& spec);

}  // namespace surefoot
