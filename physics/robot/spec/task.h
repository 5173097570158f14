// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot's file says of the task: parameters, memories, state, start, endings, rewards, measures, picture.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/environment.h"
#include "core/parameters.h"
#include "physics/robot/spec/formula.h"

namespace surefoot {

struct ConstantSpec {
  std::string name{};
  Formula value{};
};

/// A value that is carried from step to step, or from substep to substep.
struct MemorySpec {
  Formula start{}, each{};
  bool hasStart = false;  ///< else a memory of a step begins with `each`
  bool substep = false;
};

struct StateSpec {
  StateVariable words{};  ///< its texts; the numbers are formulas
  Formula value{};
  FormulaPair range{};
  std::optional<FormulaPair> view{};
  std::optional<Formula> width{}, resolution{}, span{};
  bool wrap = false;
  TextPlace place{};  ///< of its range
};

/// One coordinate of the start: of a joint, or of a body.
struct StartSpec {
  enum class What { Position, Rate, X, Y, Vx, Vy };  ///< Position: an angle, too
  bool ofBody = false;
  int index = 0;
  What what = What::Position;
  Formula value{};  ///< may hold uniform(a, b)
};

struct EndingSpec {
  enum class Kind { Fall, Goal, Out, Time };
  Kind kind = Kind::Fall;
  std::string name{};
  Formula when{};
  std::string text{};  ///< of the condition
};

struct RewardSpec {
  std::string name{};
  Formula value{};                ///< of every step
  std::optional<Formula> when{};  ///< only where this holds
  std::optional<int> ending{};    ///< only with this ending
  bool potential = false;         ///< the change of the value in a step
};

struct MeasureSpec {
  TaskMeasure words{};
  Formula value{};
  bool adds = false;  ///< a sum of every step; else the newest
};

struct PictureLineSpec {
  int from = 0, to = 0;  ///< points
  Ink ink = Ink::Outline;
  double width = 1.0;
  bool dashed = false;
};
struct PictureLabelSpec {
  int at = 0;  ///< a point
  std::string text{};
};

struct PictureSpec {
  std::optional<Formula> height{}, width{};
  int follow = -1, tip = -1;  ///< points
  bool metres = true;
  std::vector<PictureLineSpec> lines{};
  std::vector<PictureLabelSpec> labels{};
};

/// A preset or scenario: values of parameters by their full key.
struct SettingsSpec {
  std::string name{}, title{}, help{};
  std::vector<std::pair<std::string, double>> values{};
  TextPlace place{};
};

}  // namespace surefoot
