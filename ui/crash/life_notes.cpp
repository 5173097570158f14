// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/crash/life_notes.h"

#include <fmt/format.h>

#include "core/experiment/configuration.h"
#include "ui/crash/crash_notes.h"
#include "ui/running/running_life.h"

namespace surefoot {

namespace {
/// Whether the author of a robot's file chose the parameter's name.
bool isOfFile(const Configuration& c, std::string_view key) {
  return c.environmentFile && key.starts_with("environment.");
}
}  // namespace

std::string lifeLines(const Configuration& c) {
  std::string lines;
  const auto add = [&lines](std::string_view name, std::string_view value) {
    if (!value.empty()) lines += fmt::format("  {} = {}\n", name, value);
  };
  add("environment", c.environmentFile ? "a robot from a file" : c.names.environment);
  if (!c.environmentFile) {
    add("preset", c.names.preset);
    add("scenario", c.names.scenario);
  }
  add("agent", c.names.agent);
  add("features", c.names.features);
  add("policy", c.names.policy);
  add("seed", std::to_string(c.seed));
  if (c.start) add("begins with", "a Q-function from a file");
  for (const auto& entry : c.parameters.all())
    if (!isOfFile(c, entry.parameter.key)) add(entry.parameter.key, formatValue(entry.parameter, entry.value));
  return lines;
}

void noteChangesOf(RunningLife& life) {
  const auto note = [&life] { noteLife(lifeLines(life.configuration())); };
  QObject::connect(&life, &RunningLife::configurationChanged, &life, note);
  QObject::connect(&life, &RunningLife::replaced, &life, note);
  QObject::connect(&life, &RunningLife::parameterChanged, &life, [&life](const QString& key) {
    noteCommand(isOfFile(life.configuration(), key.toStdString()) ? "a parameter of the robot" : key.toStdString());
  });
  note();
}

}  // namespace surefoot
