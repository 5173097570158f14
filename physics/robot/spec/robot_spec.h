// SPDX-License-Identifier: GPL-3.0-or-later
// A robot as its file describes it (surefoot = "robot 1"): read and checked once, shared by all that live in it.
#pragma once

#include <string>
#include <vector>

#include "physics/robot/spec/bodies.h"
#include "physics/robot/spec/names.h"
#include "physics/robot/spec/task.h"

namespace surefoot {

struct RobotSpec {
  std::string name{}, title{}, help{};
  std::uint64_t fingerprint = 0;  ///< of all that the file says, whatever its comments, spaces and quotes
  Formula stepTime{};             ///< [s]
  Formula substeps{}, velocityIterations{}, positionIterations{};
  Formula gravity{};  ///< [m/s²]
  Formula scale{};    ///< Box2D's units a metre
  Formula maxSteps{}, testEvery{};
  FormulaPair returns{};  ///< bounds of an episode's reward, where axes begin

  RobotNames names{};
  std::vector<Parameter> parameters{};
  std::vector<double> defaults{};  ///< of the parameters
  std::vector<ConstantSpec> constants{};
  std::vector<BodySpec> bodies{};
  std::vector<PointSpec> points{};
  std::vector<RaySpec> rays{};
  std::vector<JointSpec> joints{};
  std::vector<ActuatorSpec> actuators{};
  GroundSpec ground{};
  ChildSpec child{};

  std::vector<MemorySpec> memories{};
  std::vector<StateSpec> states{};
  std::vector<StartSpec> start{};
  bool onGround = false;
  int atRest = -1;  ///< a point
  std::vector<EndingSpec> endings{}, events{};
  std::vector<RewardSpec> rewards{};
  std::vector<MeasureSpec> measures{};
  PictureSpec picture{};
  int push = -1;  ///< the point that a push grabs

  std::vector<SettingsSpec> presets{}, scenarios{};
  std::vector<std::pair<std::string, double>> learning{};
  std::vector<TextPlace> learningAt{};  ///< where each of these stands

  bool hasHandMade() const {
    for (const ActuatorSpec& actuator : actuators)
      if (actuator.handMade) return true;
    return false;
  }
};

}  // namespace surefoot
