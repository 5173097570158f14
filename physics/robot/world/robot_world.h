// SPDX-License-Identifier: GPL-3.0-or-later
// The Box2D side of a robot from a file. Lengths are `scale` times as large inside; masses and time are as they are,
// so forces are × s, torques, inertias, angular stiffness and damping × s².
#pragma once

#include <box2d/box2d.h>

#include <vector>

#include "physics/robot/world/assembly.h"

namespace surefoot {

class RobotWorld final : private b2ContactListener {
 public:
  RobotWorld(const RobotSpec& robot, const RobotNumbers& numbers);

  /// Puts every body in its place. The next substep begins without impulses of the past.
  void place(const std::vector<BodyPlacement>& bodies);

  /// One substep under the actuators' levels `u`. `values` gets what efforts and ghost shapes name, first. False: what
  /// came of it is no number or beyond all bounds, and the world is of no use any more.
  bool substep(std::span<double> values, std::span<const double> u);
  /// Reads probes into their places.
  void readForSubstep(std::span<double> values, std::span<const double> u) const { read(inSubstep_, values, u); }
  void readAll(std::span<double> values, std::span<const double> u) const { read(all_, values, u); }
  /// Substeps read what these expressions name, too.
  void alsoInSubstep(const Expression& expression);

  /// A horizontal impulse at a point [N s].
  void push(int point, double impulse);

  BodyPlacement placement(int body) const;
  double jointPosition(int joint) const;
  double jointRate(int joint) const;
  /// Of an actuator under the level u, in the last substep [N m], [N]; what it takes or gives [W].
  double effort(int actuator) const { return efforts_[static_cast<std::size_t>(actuator)]; }
  double power(int actuator, double u) const;
  bool touches(int body) const;
  /// The largest distance between the two ends of any joint [m].
  double jointSeparation() const;
  /// Kinetic and potential energy of all bodies [J]; springs are not in it.
  double energy() const { return motion() + height(); }
  /// The kinetic part of it.
  double motion() const;

 private:
  struct Joint {
    b2Joint* joint = nullptr;
    b2Body *parent = nullptr, *child = nullptr;
    b2WeldJoint* weld = nullptr;  ///< of a soft one
    b2PrismaticJoint* prismatic = nullptr;
    double reduced = 1.0;  ///< mass that a sliding joint moves
    bool drives = false;   ///< something besides Box2D acts there
  };
  /// What acts on a joint in a substep.
  struct Drive {
    double effort = 0.0, damping = 0.0, stiffness = 0.0;
  };
  struct Solid {
    const Expression* expression;
    std::size_t shape;
  };
  struct ReadProbe {
    Probe probe;
    std::size_t place;
    b2Body* body;
    b2Vec2 local;
    bool atCentre;  ///< the velocity is that of the body's centre of mass
  };

  void PreSolve(b2Contact* contact, const b2Manifold* old) override;

  double height() const;
  void addGround();
  void addBody(int index);
  void addShape(b2Body& body, const ShapeNumbers& shape, std::size_t number);
  void addJoint(int index);
  void addProbes();
  b2Body* bodyOf(int index) const { return index < 0 ? ground_ : bodies_[static_cast<std::size_t>(index)]; }
  b2Vec2 inside(Point v) const;

  bool actuate(std::size_t index, std::span<double> values, double u);
  bool driveVelocity(std::size_t index, double speed, double most);
  void driveSoft(std::size_t index);
  void driveSlide(std::size_t index);
  void driveHard(std::size_t index);
  bool sound() const;

  void read(const std::vector<ReadProbe>& probes, std::span<double> values, std::span<const double> u) const;
  double measured(const ReadProbe& probe, std::span<const double> u) const;
  double rayDistance(const ReadProbe& probe) const;

  const RobotSpec& robot_;
  const RobotNumbers& numbers_;
  b2World world_;
  float substepTime_;
  double scale_, h_;
  b2Body* ground_ = nullptr;
  std::vector<b2Body*> bodies_{};
  std::vector<Joint> joints_{};
  std::vector<Drive> drives_{};
  std::vector<double> efforts_{};  ///< of the actuators, in the last substep
  std::vector<Solid> solids_{};
  std::vector<char> solid_{};  ///< of every shape
  std::vector<ReadProbe> all_{}, inSubstep_{};
  bool fresh_ = true;
};

}  // namespace surefoot
