// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/inspection/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "physics/robot/spec/every_formula.h"

namespace surefoot {

namespace {

class Warnings {
 public:
  Warnings(const RobotSpec& spec, const Task& task, const RandomLifeSeen& seen, EnvironmentInspection& found)
      : spec_(spec),
        task_(task),
        seen_(seen),
        found_(found) {}

  void all() {
    warnOfStates();
    warnOfParts();
    warnOfTask();
    warnOfWorld();
    std::stable_sort(found_.warnings.begin(), found_.warnings.end(),
                     [](const Complaint& a, const Complaint& b) { return a.at.line < b.at.line; });
  }

 private:
  void warn(TextPlace at, std::string sentence) { found_.warnings.push_back({at, std::move(sentence)}); }

  void warnOfStates() {
    for (std::size_t s = 0; s < found_.states.size(); ++s) {
      const SeenState& seen = found_.states[s];
      const TextPlace at = spec_.states[s].place;
      if (seen.seenHigh <= seen.seenLow)
        warn(at, fmt::format("{} never changes in {} random steps.", seen.key, kInspectedSteps));
      else if (seen.outside > 0.05)
        warn(at, fmt::format("{} leaves its range {:.4g} … {:.4g} in {:.0f} % of random steps; it came to {:.4g} … "
                             "{:.4g}.",
                             seen.key, seen.low, seen.high, 100 * seen.outside, seen.seenLow, seen.seenHigh));
      else if (seen.seenHigh - seen.seenLow < 0.15 * (seen.high - seen.low) && !task_.state[s].period)
        warn(at, fmt::format("{} came to {:.4g} … {:.4g} only, of {:.4g} … {:.4g}; what has learned may go farther, so "
                             "look at a learned life before you narrow it.",
                             seen.key, seen.seenLow, seen.seenHigh, seen.low, seen.high));
      for (std::size_t other = 0; other < s; ++other)
        if (alike(s, other))
          warn(at, fmt::format("{} and {} always agree; one of them is enough.", found_.states[other].key, seen.key));
    }
  }
  bool alike(std::size_t a, std::size_t b) const {
    return std::all_of(seen_.states.begin(), seen_.states.end(),
                       [&](const auto& state) { return std::abs(state[a] - state[b]) < 1e-9; });
  }

  /// Whether a joint, or the like, has to do with a body.
  bool isHeld(std::size_t body) const {
    const int b = static_cast<int>(body);
    return std::any_of(spec_.joints.begin(), spec_.joints.end(),
                       [b](const JointSpec& joint) { return joint.parent == b || joint.child == b; });
  }

  void warnOfParts() {
    for (std::size_t b = 0; b < spec_.bodies.size() && spec_.bodies.size() > 1; ++b)
      if (!isHeld(b) && !spec_.bodies[b].still)
        warn(spec_.bodies[b].place, fmt::format("no joint holds the body {}: it lies loose.", spec_.bodies[b].name));
    const auto warnOfLevels = [&](const std::string& name, std::vector<double> levels) {
      std::sort(levels.begin(), levels.end());
      if (const auto twice = std::adjacent_find(levels.begin(), levels.end()); twice != levels.end())
        warn({1, 1}, fmt::format("{} has the level {:.4g} twice.", name, *twice));
    };
    for (const ActionVariable& v : task_.actionVariables) warnOfLevels(v.key, v.levels);
    if (task_.actionVariables.empty()) warnOfLevels(task_.actionTitle, task_.actions);
    if (task_.actions.size() == 1) warn({1, 1}, "there is one action only: nothing can be chosen.");
    for (std::size_t r = 0; r < spec_.rewards.size(); ++r)
      for (std::size_t other = 0; other < r; ++other)
        if (spec_.rewards[other].name == spec_.rewards[r].name)
          warn(spec_.rewards[r].value.at, fmt::format("two rewards are called {}.", spec_.rewards[r].name));
  }

  void warnOfTask() {
    const TextPlace top{1, 1};
    std::set<int> used;
    collectUses(used);
    for (std::size_t p = 0; p < spec_.parameters.size() && !spec_.names.hasChild(); ++p)  // a program gets all
      if (!used.contains(static_cast<int>(p)))
        warn(top, fmt::format("nothing uses the parameter {}.", spec_.parameters[p].key));
    if (!task_.canFall) warn(top, "no ending is a fall: falls cannot be counted.");
    if (seen_.starts.size() == 1 && seen_.episodes > 1) warn(top, "every episode begins alike.");
    if (seen_.atOnce > 0)
      warn(top, fmt::format("{} of {} episodes end in their first step.", seen_.atOnce, seen_.episodes));
    for (std::size_t r = 0; r < seen_.rewarded.size(); ++r) {
      const RewardSpec& reward = spec_.rewards[r];
      const bool rare = reward.ending && found_.endings[static_cast<std::size_t>(*reward.ending)].count == 0;
      if (!seen_.rewarded[r] && !rare)
        warn(reward.value.at, fmt::format("the reward {} was never other than 0.", reward.name));
    }
    const bool hashed = std::any_of(spec_.learning.begin(), spec_.learning.end(),
                                    [](const auto& l) { return l.first == "features.memory" && l.second > 0; });
    if (found_.tiles > 2.7e7 && !hashed)
      warn(top,
           fmt::format("a dense table has {:.3g} tiles a tiling; give it a memory, or wider tiles.", found_.tiles));
  }

  void collectUses(std::set<int>& used) const {
    const auto add = [&](const Formula& formula) {
      for (const int place : formula.expression.variables()) used.insert(place);
    };
    forEveryFormula(spec_, add);
  }

  void warnOfWorld() {
    const TextPlace top{1, 1};
    if (const double loss = found_.passive.lossPerSecond(); loss > 0.05)
      warn(spec_.substeps.at.line > 0 ? spec_.substeps.at : top,
           fmt::format(
               "left to itself the robot loses {:.0f} % of its motion a second, by the size of the substep alone "
               "({:.0f} % with twice as many substeps).",
               100 * loss, 100 * found_.halved.lossPerSecond()));
    if (found_.jointGap > 1e-3)
      warn(top,
           fmt::format("joints part by up to {:.2g} mm; more iterations hold them together.", 1000 * found_.jointGap));
    if (found_.smallestRadius > 0.0 && found_.smallestRadius * found_.scale < 0.1)
      warn(top, fmt::format("the smallest part that meets something is {:.3g} of Box2D's units, near the slop of its "
                            "contacts; scale = {:.0f} makes it 0.2.",
                            found_.smallestRadius * found_.scale, found_.proposedScale));
    if (found_.flewApart > 0)
      warn(top, fmt::format("it flew apart {} times in {} random steps.", found_.flewApart, kInspectedSteps));
  }

  const RobotSpec& spec_;
  const Task& task_;
  const RandomLifeSeen& seen_;
  EnvironmentInspection& found_;
};

}  // namespace

void addWarnings(const RobotSpec& spec, const Task& task, const RandomLifeSeen& seen, EnvironmentInspection& found) {
  Warnings(spec, task, seen, found).all();
}

}  // namespace surefoot
