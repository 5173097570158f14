// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/robot_entry.h"

#include <fmt/format.h>

#include <algorithm>

#include "physics/robot/reading/robot_reading.h"
#include "physics/robot/robot.h"

namespace surefoot {

namespace {

using Values = std::vector<std::pair<std::string, double>>;

/// Presets or scenarios of a file; in front of them the robot as it stands there, unless one of them is that.
std::vector<AssignmentEntry> entriesOf(const std::vector<SettingsSpec>& all, const std::string& environment,
                                       const Values& under) {
  std::vector<AssignmentEntry> entries;
  if (std::none_of(all.begin(), all.end(), [](const SettingsSpec& s) { return s.values.empty(); }))
    entries.push_back({{"as-built", "As built", "The values of the robot's file."}, environment, {}});
  for (const SettingsSpec& settings : all)
    entries.push_back({{settings.name, settings.title, settings.help}, environment, settings.values});
  for (AssignmentEntry& entry : entries) entry.values.insert(entry.values.begin(), under.begin(), under.end());
  return entries;
}

}  // namespace

EnvironmentFile robotEntry(const std::string& name, std::shared_ptr<const RobotSpec> spec) {
  EnvironmentFile file;
  file.presets = entriesOf(spec->presets, name, spec->learning);
  if (!spec->scenarios.empty()) file.scenarios = entriesOf(spec->scenarios, name, {});
  file.entry = {{name, spec->title, spec->help}, [spec = std::move(spec)] { return std::make_unique<Robot>(spec); }};
  return file;
}

std::optional<EnvironmentFile> readRobotEntry(std::string_view text, std::vector<Complaint>& complaints,
                                              const RobotInspector& inspector) {
  const auto spec = readRobot(text, complaints);
  if (spec) complaints = checkRobot(*spec);
  if (!complaints.empty()) return std::nullopt;
  auto entry = robotEntry(fmt::format("{}@{:08x}", spec->name, spec->fingerprint >> 32), spec);
  entry.text = text;
  entry.inspect = [spec, inspector] { return inspector(spec); };
  return entry;
}

void addRobot(Registry& registry, EnvironmentFile robot) {
  registry.environments.push_back(std::move(robot.entry));
  for (auto& preset : robot.presets) registry.presets.push_back(std::move(preset));
  for (auto& scenario : robot.scenarios) registry.scenarios.push_back(std::move(scenario));
}

}  // namespace surefoot
