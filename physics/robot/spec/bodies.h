// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies, joints, motors and ground as a robot's file gives them. Everything stands in the drawing: the pose in which
// all joint coordinates are 0. SI units; angles in radians, counter-clockwise. An index of −1 is "none" or the world.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"
#include "physics/robot/spec/formula.h"

namespace surefoot {

/// What a part touches: nothing, the ground, or the ground and other parts that meet all.
enum class Meets { Nothing, Ground, All };

struct ShapeSpec {
  enum class Kind { Circle, Box, Polygon, Rod };
  Kind kind = Kind::Circle;
  std::string name{};
  Formula radius{};                    ///< of a circle; of a rod's round ends [m]
  FormulaPair size{};                  ///< of a box [m]
  FormulaPair at{}, to{};              ///< in the body's frame; a rod leads to `to` [m]
  Formula angle{};                     ///< of a box or polygon [rad]
  std::vector<FormulaPair> corners{};  ///< of a polygon [m]
  Formula friction{}, restitution{}, density{};
  Meets meets = Meets::Ground;
  std::optional<Formula> solid{};  ///< moving: while it is 0 the shape touches nothing
  Ink ink = Ink::Solid;
  Fill fill = Fill::Panel;
  double width = 2.0;  ///< of its outline [px]
  bool drawn = true;
  TextPlace place{};
};

struct BodySpec {
  std::string name{};
  FormulaPair at{};  ///< of its origin [m]
  Formula angle{};
  std::optional<Formula> mass{};                        ///< [kg]; none: from the density of its shapes
  std::optional<Formula> inertia{}, inertiaAtOrigin{};  ///< about the centre of mass, about the origin [kg m²]
  std::optional<FormulaPair> centre{};                  ///< of mass, in the body's frame [m]
  bool rotates = true, still = false;
  std::vector<ShapeSpec> shapes{};
  TextPlace place{};
};

struct PointSpec {
  int body = 0;
  FormulaPair at{};  ///< in the body's frame [m]; moving, in the world, where a program moves the robot
};

/// A ray from a point, turned with its body, to the ground.
struct RaySpec {
  int point = 0;
  Formula angle{}, length{};
};

struct JointSpec {
  enum class Kind { Revolute, Prismatic, Weld, Wheel, Distance };
  Kind kind = Kind::Revolute;
  std::string name{};
  int parent = -1, child = 0;  ///< bodies
  FormulaPair at{};            ///< in the drawing [m]
  FormulaPair to{};            ///< the child's end of a distance
  FormulaPair axis{};          ///< of prismatic and wheel, in the drawing
  std::optional<FormulaPair> limits{};
  std::optional<FormulaPair> stop{};  ///< stiffness and damping of soft limits
  std::optional<Formula> damping{}, armature{}, stiffness{};
  Formula friction{}, rest{};
  bool soft = false;  ///< asked for
  bool drawn = true;
  TextPlace place{};
};

struct ActuatorSpec {
  enum class Kind { Torque, Force, DcMotor, Position, Velocity };
  Kind kind = Kind::Torque;
  std::string name{}, title{}, symbol{}, unit{};
  int joint = -1;                                                ///< or
  int point = -1;                                                ///< where a force acts,
  FormulaPair direction{};                                       ///< in this direction of the world
  std::vector<Formula> levels{};                                 ///< empty: it looks after itself
  std::optional<Formula> effort{};                               ///< moving: in every substep; none: u
  std::optional<Formula> handMade{};                             ///< moving: u of the hand-made controller
  std::optional<Formula> limit{};                                ///< moving
  Formula resistance{}, torqueConstant{}, gear{}, efficiency{};  ///< of a DC motor [Ω], [N m/A], –, –
  Formula stiffness{}, damping{};                                ///< of a position servo
  std::optional<Formula> width{};                                ///< of a level's tile
  int arrow = -1;                                                ///< the point where it is drawn
  double arrowScale = 1.0;
  TextPlace place{};
};

/// A program that moves the robot in place of Box2D. What it sends: reward, terminated and truncated of its own, then
/// the numbers of the file's `sends`.
struct ChildSpec {
  static constexpr std::size_t kReward = 0, kTerminated = 1, kTruncated = 2, kOwn = 3;
  std::vector<std::string> command{};  ///< empty: there is none
  std::vector<std::string> sends{};    ///< with the three of its own
  TextPlace place{};
};

struct GroundSpec {
  enum class Kind { None, Flat, Polyline, Steps, Bumps };
  Kind kind = Kind::Flat;
  Formula friction{};
  Formula slope{};                           ///< [rad]; gravity is tilted by it
  std::vector<FormulaPair> points{};         ///< of a polyline
  Formula length{}, height{}, from{}, to{};  ///< of steps and bumps [m]
  Formula seed{};
  TextPlace place{};
};

}  // namespace surefoot
