// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be chosen by name. Menus, forms, command line, files and contract tests read it. Filled by
// explicit calls (registerCore, registerPhysics); adding an environment, a policy or an agent is a new file and a line
// there.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/agent.h"
#include "core/basics/result.h"
#include "core/environment.h"
#include "core/policy.h"

namespace surefoot {

/// The description that every entry has.
struct Named {
  std::string name;   ///< in files and on the command line: "epsilon-greedy"
  std::string title;  ///< in the window: "ε-greedy"
  std::string help;   ///< one sentence
};

struct EnvironmentEntry : Named {
  std::function<std::unique_ptr<Environment>()> make;
};

struct PolicyEntry : Named {
  std::function<std::unique_ptr<Policy>()> make;
};

/// A set of parameter values by name: a scenario of the thesis, a preset.
struct AssignmentEntry : Named {
  std::string environment;  ///< the environment that it is meant for
  std::vector<std::pair<std::string, double>> values;
};

struct FeatureEntry : Named {};

/// The parts from which an agent is built.
struct AgentParts {
  const Task& task;
  const std::string& features;
  const Parameters& parameters;
  std::uint64_t weightSeed;
  const TensorFile* stored = nullptr;  ///< the learned tables to begin with

  int actions() const { return static_cast<int>(task.actions.size()); }
};

struct AgentEntry : Named {
  /// Adds the parameters of the learning rule ("agent.…") and of its representation ("features.…").
  std::function<Status(const Task& task, const std::string& features, Parameters& parameters)> declare;
  std::function<Result<std::unique_ptr<Agent>>(const AgentParts& parts)> make;
};

class EnvironmentLibrary;
class EnvironmentPrograms;

struct Registry {
  std::vector<EnvironmentEntry> environments;
  std::vector<FeatureEntry> features;
  std::vector<AgentEntry> agents;
  std::vector<PolicyEntry> policies;
  std::vector<AssignmentEntry> presets;
  std::vector<AssignmentEntry> scenarios;
  std::shared_ptr<EnvironmentLibrary> files;  ///< environments from files; shared by all copies; null: there are none
  std::shared_ptr<EnvironmentPrograms> programs{};  ///< which of these may start a program; null as above
};

/// "policy: there is no \"softmx\"; choose greedy, softmax or trl (did you mean softmax?)."
Error unknownName(std::string_view what, std::string_view name, const std::vector<std::string>& names);

/// Finds an entry by name; otherwise a sentence with the names there are and the nearest of them.
template <class Entry>
Result<const Entry*> findEntry(const std::vector<Entry>& entries, std::string_view what, std::string_view name) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    if (entry.name == name) return &entry;
    names.push_back(entry.name);
  }
  return unknownName(what, name, names);
}

/// The measures of the tasks of some environments, each key once. Names that are not registered have none.
std::vector<TaskMeasure> taskMeasuresOf(const Registry& registry, const std::set<std::string>& environments);

}  // namespace surefoot
