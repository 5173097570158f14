// SPDX-License-Identifier: GPL-3.0-or-later
// From the coordinates of joints and free bodies to where every body is: nothing is ever torn.
#pragma once

#include "physics/robot/world/robot_numbers.h"

namespace surefoot {

struct BodyPlacement {
  Point at{};          ///< of the origin [m]
  double angle = 0.0;  ///< [rad]
  Point velocity{};    ///< of the origin [m/s]
  double rate = 0.0;   ///< [rad/s]
};

/// A coordinate of every joint and of every body that hangs on none.
struct Coordinates {
  std::vector<double> joints{}, jointRates{};
  std::vector<BodyPlacement> free{};  ///< of all bodies; only those of free ones count
  /// Angle and rate of bodies that hang on a joint, given in the world and not in the joint.
  std::vector<std::optional<double>> angles{}, rates{};
};

class Assembly {
 public:
  Assembly(const RobotSpec& robot, const RobotNumbers& numbers);

  /// The drawing, at rest.
  Coordinates drawing() const;
  /// Draws the start from its distribution, on the ground and at rest where the robot wants that.
  std::vector<BodyPlacement> start(std::span<const double> values, Random& random) const;
  std::vector<BodyPlacement> placed(const Coordinates& coordinates) const;
  /// The same on the ground and with its point at rest, if the robot begins so.
  std::vector<BodyPlacement> settled(const Coordinates& coordinates) const;

  bool isFree(int body) const { return isFree_[static_cast<std::size_t>(body)]; }
  /// Joints that close a loop.
  const std::vector<int>& closing() const { return closing_; }
  /// How far apart the ends of such a joint are [m].
  double gap(int joint, const std::vector<BodyPlacement>& bodies) const;

 private:
  /// A step of the way through the robot: a free body, or one that hangs on a body placed before.
  struct Link {
    int joint;  ///< −1: a free body
    int body;
    bool backwards;  ///< the child is there, the parent hangs on it
  };

  void hang(const Link& link, const Coordinates& c, std::vector<BodyPlacement>& bodies) const;
  void settle(std::vector<BodyPlacement>& bodies) const;
  double lowestGap(const std::vector<BodyPlacement>& bodies) const;

  const RobotSpec& robot_;
  const RobotNumbers& numbers_;
  std::vector<Link> links_;
  std::vector<bool> isFree_;
  std::vector<int> closing_;
};

Point turned(Point v, double angle);
/// Where a point of a body is, and how fast.
Point placeOf(const BodyPlacement& body, Point point);
Point velocityOf(const BodyPlacement& body, Point point);

}  // namespace surefoot
