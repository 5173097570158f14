// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string_view>

#include "core/basics/expects.h"
#include "physics/robot/child/child_robot.h"
#include "physics/robot/reading/robot_reading.h"
#include "physics/robot/robot.h"

namespace surefoot {

/// Whatever the text is, it is refused with sentences, or lives: 150 random steps with finite states, drawn, pushed and
/// placed where it was. True: it lived.
inline bool useRobot(std::string_view text) {
  std::vector<Complaint> complaints;
  const auto spec = readRobot(text, complaints);
  if (spec) complaints = checkRobot(*spec);
  for (const Complaint& c : complaints) expects(c.sentence.ends_with('.'), "a sentence");
  if (!complaints.empty()) return false;
  Random random(1);
  Scene scene;
  if (spec->names.hasChild()) {  // its program is not started: nobody has allowed it
    ChildRobot child(spec, "program", ".", std::make_shared<EnvironmentPrograms>());
    child.reset(random);
    expects(child.step(0).ending == Ending::Unanswered, "nothing answers");
    child.draw(child.pose(), scene);
    return true;
  }
  Robot robot(spec);
  robot.reset(random);
  const auto actions = static_cast<double>(robot.task().actions.size());
  for (int step = 0; step < 150; ++step) {
    if (robot.step(static_cast<Action>(random.uniform() * actions)).ending != Ending::None) robot.reset(random);
    static_cast<void>(robot.push(0.01));
  }
  robot.draw(robot.pose(), scene);
  return true;
}

}  // namespace surefoot
