// SPDX-License-Identifier: GPL-3.0-or-later
// The bodies and joints of LEO (wcaarls/grl, addons/leosim; facts), each number of them a parameter. Planar: x forward,
// y up, angles counter-clockwise, so a leg in front is positive, a torso that leans forward negative, a bent knee
// negative. Lengths in m, in the frame of each body.
#pragma once

#include <array>

#include "core/parameters.h"

namespace surefoot::leo {

struct Vec {
  double x, y;
};

/// The torso holds the boom as a virtual mass and the arm, which is welded on.
enum Body { kTorso, kLeftThigh, kRightThigh, kLeftShank, kRightShank, kLeftFoot, kRightFoot, kBodies };
/// A joint bears the name of its child; `left` and `right` are the legs 0 and 1.
enum Joint { kLeftHip, kRightHip, kLeftKnee, kRightKnee, kLeftAnkle, kRightAnkle, kJoints };

struct Mass {
  double mass;     // [kg]
  double inertia;  // about its centre [kg m²]
  Vec centre;
};

/// A kind of joint: where it is in parent and child, its limits [rad], and the spring and damper at them [N m/rad, N m
/// s/rad].
struct JointKind {
  Vec inParent, inChild;
  double low, high;
  double stopStiffness, stopDamping;
};

/// A part that meets the floor, and nothing else.
struct Circle {
  Vec centre;
  double radius;
};

/// Both legs are alike.
struct Anatomy {
  Mass torso{1.32599, 0.0097049, {0.00059, -0.02640}};  ///< with the boom as a virtual mass and the arm, welded on
  Mass thigh{0.17978, 0.000273133, {0.00285, -0.00481}};
  Mass shank{0.12691, 0.000153379, {0.00804, -0.00867}};
  Mass foot{0.07319, 0.000048812, {0.00048, 0.00461}};

  JointKind hip{{0.00273, -0.120775}, {0.0, 0.058}, -0.785398, 2.548181, 100.0, 10.0};
  JointKind knee{{0.0, -0.058}, {-0.00405, 0.05225}, -2.617994, 0.034907, 50.0, 5.0};
  JointKind ankle{{0.0, -0.05225}, {-0.009, 0.03559}, -1.570796, 1.448623, 100.0, 10.0};

  Circle heel{{-0.0405, -0.0095}, 0.0035};
  Circle toe{{0.0405, -0.0095}, 0.0035};
  Circle kneeCap{{0.0405, 0.06875}, 0.0035};  ///< on the shank
  Circle seat{{-0.01116, -0.122005}, 0.068};  ///< on the torso
  Vec boomPoint{0.02, -0.120775};             ///< on the torso, where the boom's force acts

  /// At the start, at rest: angles of the bodies [rad]. The left leg stands.
  std::array<double, kBodies> start = {-0.10, 0.0, 0.72, 0.0, -0.55, 0.0, -0.55};

  void declare(Fields& f);
};

}  // namespace surefoot::leo
