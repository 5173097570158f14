// SPDX-License-Identifier: GPL-3.0-or-later
// The names of a robot's file, all in one space, and the places of their values: one row of numbers holds parameters,
// constants, memories, states, `step`, `time`, and what is measured of the moving robot because an expression names it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/files/toml_tree.h"

namespace surefoot {

enum class NameKind { Parameter, Constant, Body, Point, Joint, Actuator, Ray, Memory, State, Child };

/// Something measured of the moving robot, for example the height of a point; or what a program sent that moves it.
struct Probe {
  enum class What { X, Y, Angle, Vx, Vy, Rate, Height, Touches, U, Effort, Power, Distance, Sent };
  NameKind of = NameKind::Body;
  int index = 0;   ///< of the body, point, joint, actuator or ray; of the number in ChildSpec::sends
  int shape = -1;  ///< of the body; −1: all of it
  What what = What::X;

  bool operator==(const Probe&) const = default;
};

class RobotNames {
 public:
  struct Name {
    std::string text;
    NameKind kind;
    int index;  ///< among the names of its kind
  };

  /// False: there is another of this name.
  bool add(NameKind kind, const std::string& name);
  /// Names of a body's shapes, which count within the body; an empty one for a shape without.
  void addShapes(std::vector<std::string> shapes) { shapes_.push_back(std::move(shapes)); }

  /// A program moves the robot: the names of the numbers that it sends.
  void setSent(std::vector<std::string> numbers) { sent_ = std::move(numbers), hasChild_ = true; }
  bool hasChild() const { return hasChild_; }
  const std::vector<std::string>& sent() const { return sent_; }

  const Name* find(std::string_view name) const;
  int count(NameKind kind) const;
  const std::string& nameOf(NameKind kind, int index) const;
  const std::vector<std::string>& shapesOf(int body) const { return shapes_[static_cast<std::size_t>(body)]; }
  std::vector<std::string> all() const;
  std::vector<std::string> all(NameKind kind) const;

  /// Places, once all names are there: parameters, constants, memories, states, step, time, probes.
  int placeOf(NameKind kind, int index) const;
  int placeOfStep() const { return placeOf(NameKind::State, count(NameKind::State)); }
  int placeOfTime() const { return placeOfStep() + 1; }
  /// A probe gets a place when it is asked for first.
  int placeOfProbe(const Probe& probe);
  const std::vector<Probe>& probes() const { return probes_; }
  int firstProbe() const { return placeOfTime() + 1; }
  int places() const { return firstProbe() + static_cast<int>(probes_.size()); }

 private:
  std::vector<Name> names_;
  std::vector<std::vector<std::string>> shapes_;
  std::vector<Probe> probes_;
  std::vector<std::string> sent_;
  bool hasChild_ = false;
};

/// Why this cannot be a name; nothing: it can.
const char* wrongName(std::string_view name);

}  // namespace surefoot
