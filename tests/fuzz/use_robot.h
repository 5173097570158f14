// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string_view>

#include "core/basics/expects.h"
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
  Robot robot(spec);
  Random random(1);
  robot.reset(random);
  const auto actions = static_cast<double>(robot.task().actions.size());
  for (int step = 0; step < 150; ++step) {
    if (robot.step(static_cast<Action>(random.uniform() * actions)).ending != Ending::None) robot.reset(random);
    static_cast<void>(robot.push(0.01));
  }
  Scene scene;
  robot.draw(robot.pose(), scene);
  return true;
}

}  // namespace surefoot
