// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/robot_entry.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/basics/hash64.h"
#include "physics/robot/child/program_files.h"
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

/// Whether a joint holds the robot to the world.
bool hangs(const RobotSpec& spec) {
  return std::any_of(spec.joints.begin(), spec.joints.end(), [](const JointSpec& joint) { return joint.parent < 0; });
}

/// A robot that a program moves: its name counts the program's files, too.
void addProgram(const std::shared_ptr<const RobotSpec>& spec, const std::string& folder, const RobotTools& tools,
                const std::shared_ptr<const EnvironmentPrograms>& programs, EnvironmentFile& file) {
  file.starts = commandText(*spec);
  file.program = programOf(*spec, folder);
  const auto make = [=, program = file.program] {
    return std::make_unique<ChildRobot>(spec, program, folder, programs);
  };
  file.entry.make = make;
  file.passive = file.dropped = nullptr;
  file.inspect = [=] { return tools.inspect(spec, make()); };
}

/// What [learning] says must be allowed.
void checkLearning(const std::shared_ptr<const RobotSpec>& spec, const RobotTools& tools,
                   std::vector<Complaint>& complaints) {
  if (spec->learning.empty() || spec->names.hasChild() || !tools.parameters) return;
  Parameters parameters = tools.parameters(Robot(spec).task());
  const auto& all = spec->learning;
  for (std::size_t from = 0, to = 0; from < all.size(); from = to) {  // a short word stands for several keys
    const TextPlace at = spec->learningAt[from];
    for (to = from; to < all.size() && spec->learningAt[to].line == at.line; ++to) {
    }
    std::size_t wrong = from;  // a key that must be told: one that takes no such value, or the only one there is
    while (wrong < to && (!parameters.find(all[wrong].first) || parameters.set(all[wrong].first, all[wrong].second)))
      ++wrong;
    const bool unknown =
        std::none_of(all.begin() + static_cast<std::ptrdiff_t>(from), all.begin() + static_cast<std::ptrdiff_t>(to),
                     [&](const auto& entry) { return parameters.find(entry.first) != nullptr; });
    if (wrong == to && !unknown) continue;
    const auto& [key, value] = all[wrong == to ? from : wrong];
    complaints.push_back({at, parameters.set(key, value).error().message});
  }
}

}  // namespace

EnvironmentFile robotEntry(const std::string& name, std::shared_ptr<const RobotSpec> spec) {
  EnvironmentFile file;
  file.presets = entriesOf(spec->presets, name, spec->learning);
  if (!spec->scenarios.empty()) file.scenarios = entriesOf(spec->scenarios, name, {});
  file.entry = {{name, spec->title, spec->help}, [spec = std::move(spec)] { return std::make_unique<Robot>(spec); }};
  return file;
}

std::optional<EnvironmentFile> readRobotEntry(std::string_view text, const std::string& folder,
                                              std::vector<Complaint>& complaints, const RobotTools& tools,
                                              const std::shared_ptr<const EnvironmentPrograms>& programs) {
  const auto spec = readRobot(text, complaints);
  if (spec) complaints = checkRobot(*spec);
  if (spec && complaints.empty()) checkLearning(spec, tools, complaints);
  if (!complaints.empty()) return std::nullopt;
  Hash64 hash;
  if (spec->names.hasChild()) hash.add(printOfFiles(*spec, folder));
  hash.add(spec->fingerprint);
  const std::uint64_t print = spec->names.hasChild() ? hash.value() : spec->fingerprint;
  auto file = robotEntry(fmt::format("{}@{:08x}", spec->name, print >> 32), spec);
  file.text = text;
  file.inspect = [=] { return tools.inspect(spec, nullptr); };
  if (hangs(*spec))
    file.passive = [=] { return std::make_unique<Robot>(tools.passive(*spec)); };
  else
    file.dropped = [=] { return std::make_unique<Robot>(tools.dropped(*spec)); };
  if (spec->names.hasChild()) addProgram(spec, folder, tools, programs, file);
  return file;
}

void addRobot(Registry& registry, EnvironmentFile robot) {
  registry.environments.push_back(std::move(robot.entry));
  for (auto& preset : robot.presets) registry.presets.push_back(std::move(preset));
  for (auto& scenario : robot.scenarios) registry.scenarios.push_back(std::move(scenario));
}

}  // namespace surefoot
