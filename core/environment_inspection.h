// SPDX-License-Identifier: GPL-3.0-or-later
// What an environment from a file does by itself and under random actions, held against what its text says. Values.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/files/toml_tree.h"
#include "core/scene.h"

namespace surefoot {

/// A state variable under random actions.
struct SeenState {
  static constexpr std::size_t kBins = 32;  ///< over the range and a quarter of it to either side
  std::string key{}, title{}, symbol{}, unit{};
  double low = 0.0, high = 0.0;          ///< as the file says
  double seenLow = 0.0, seenHigh = 0.0;  ///< as it came
  double outside = 0.0;                  ///< share of steps beyond the range
  std::array<int, kBins> bins{};
  int tiles = 0;       ///< over the range
  double width = 0.0;  ///< of a tile
  /// A range that holds all that was seen, and never less than the file's; rounded outwards.
  double proposedLow = 0.0, proposedHigh = 0.0;
  TextPlace rangeAt{};  ///< of the range in the text

  bool proposes() const { return proposedLow != low || proposedHigh != high; }
};

struct SeenEnding {
  std::string name{}, when{};
  bool fall = false;
  int count = 0;
};

/// A body, joint, point or motor, for names beside the picture.
struct NamedPart {
  std::string name{}, about{};  ///< "hip", "trunk to thigh, −0.8 … 0.8 rad"
  Point at{};                   ///< in the drawing
  int line = 0;                 ///< of the text
};

/// A limit of a joint that turns, as a handle that can be dragged.
struct AngleHandle {
  std::string joint{};
  Point centre{};
  double zero = 0.0;   ///< the direction of the child where the coordinate is 0 [rad]
  double angle = 0.0;  ///< the limit [rad]
  bool upper = false;
  std::optional<TextPlace> number{};  ///< where it stands in the text; nothing: it is an expression
};

/// The robot without motors, dampers, springs, friction and contacts, from a start on.
struct PassiveEnergy {
  double seconds = 0.0, begins = 0.0, ends = 0.0;  ///< [s], [J]
  double largestMotion = 0.0;                      ///< the largest kinetic energy [J]
  /// Share of the largest kinetic energy that is lost in a second: what the integrator damps.
  double lossPerSecond() const {
    return seconds > 0.0 && largestMotion > 0.0 ? (begins - ends) / (largestMotion * seconds) : 0.0;
  }
};

/// What an expression of the text is worth at the start of an episode.
struct FormulaValue {
  TextPlace at{};
  double value = 0.0;
};

struct EnvironmentInspection {
  std::string title{}, name{};
  std::vector<SeenState> states{};
  std::string actions{};  ///< "hip torque and thrust: 3 × 2 = 6"
  std::vector<SeenEnding> endings{};
  int stepLimit = 0;
  double stepTime = 0.0;  ///< [s]
  std::vector<NamedPart> parts{};
  std::vector<AngleHandle> handles{};
  Scene drawing{};  ///< the pose in which all coordinates are 0

  int steps = 0;                                           ///< of random actions
  std::vector<double> trace{};                             ///< a number of every step, by which one sees what happens
  std::string traceTitle{};                                ///< "height of the trunk [m]"
  std::vector<int> falls{};                                ///< the steps at which it fell
  std::vector<int> begins{};                               ///< the steps at which episodes began
  double meanSteps = 0.0;                                  ///< of the episodes
  double medianToFall = 0.0;                               ///< [s]; 0: it never fell
  double longest = 0.0;                                    ///< episode [s]
  std::vector<std::pair<std::string, double>> atLimits{};  ///< share of steps in which a joint was at a limit
  std::int64_t flewApart = 0;
  std::string verdict{};
  std::vector<FormulaValue> formulas{};
  std::string unanswered{};  ///< why its program did not answer; nothing was judged then

  double tiles = 0.0;                 ///< of a dense table of all actions, a tiling
  PassiveEnergy passive{}, halved{};  ///< with the file's substeps, and with twice as many
  double jointGap = 0.0;              ///< the largest distance of a joint's two ends under random actions [m]
  double smallestRadius = 0.0;        ///< of what meets something [m]; 0: nothing does
  double scale = 1.0, proposedScale = 1.0;
  std::vector<std::pair<std::string, bool>> joints{};  ///< whether the joint is soft
  std::vector<Complaint> warnings{};
};

}  // namespace surefoot
