// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment as a value: the names of its parts, every parameter, how many lives, how long, and the master seed.
// Configuration and seed together fix every bit of the result.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/life/life.h"
#include "core/parameters.h"
#include "core/registry.h"

namespace surefoot {

struct EnvironmentFile;

/// The parts that a person chooses by name.
struct Names {
  std::string environment = "pendulum";  ///< or the path of a robot's file; configure() puts its name here
  std::string preset{};                  ///< empty: the environment's first, if it has any
  std::string scenario{};                ///< likewise
  std::string agent = "sarsa";
  std::string features = "tile-coder";
  std::string policy = "epsilon-greedy";
};

/// "key=value", the value still as text.
struct Assignment {
  std::string key, value;
};

/// A command for every life after `step` steps, as a person writes it: a parameter and its value, "policy" and a name,
/// "push" and an impulse in N s, "place" and a state, or "go_on" and an episode (core/life/inputs_text.h).
struct CommandText {
  std::int64_t step = 0;
  std::string key, value;
};

struct Configuration {
  Names names;
  std::shared_ptr<const EnvironmentFile> environmentFile;  ///< null: the environment is compiled in
  std::string otherProgram{};  ///< the name of the environment when its program was another one; empty: it is the same
  Parameters parameters;       ///< complete: environment, agent, features, and every policy's
  std::uint64_t seed = 1;
  int lives = 1;
  std::optional<double> minutes;         ///< simulated minutes per life
  std::optional<std::int64_t> episodes;  ///< episodes per life; the limit that is reached first ends it
  std::optional<double> until;           ///< the average reward of the last 80 episodes that ends a life, too
  std::vector<CommandText> commands;     ///< in the order of their steps
  /// The Q-function that every life begins with; null: none. Shared, because it is large and many lives read it.
  std::shared_ptr<const TensorFile> start;
  Json beganWith;  ///< the file of `start`, with its hash and description; null: none
  /// The Q-function that can act as guardian (policy.guardian = q-function); null: none.
  std::shared_ptr<const TensorFile> teacher;
};

/// Whether a program moves the environment: its lives have the same bits on the same machine only.
bool isMovedByProgram(const Configuration& configuration);

/// Looks the names up and fills in every parameter: defaults, then the preset, then the scenario, then `assignments`.
Result<Configuration> configure(const Registry& registry, const Names& names,
                                const std::vector<Assignment>& assignments);

/// A configuration under other names; it keeps the values of all parameters that both have.
Result<Configuration> configurationUnder(const Registry& registry, const Configuration& now, const Names& names);

/// Takes the Q-function away that could act as guardian; nobody does then, if it did.
void leaveTeacher(Configuration& configuration);

/// The keys that a policy reads, e.g. "policy.epsilon".
std::vector<std::string> policyKeys(const PolicyEntry& policy);

/// A policy with its parameters from the configuration.
Result<std::unique_ptr<Policy>> makePolicy(const Registry& registry, const std::string& name,
                                           const Parameters& parameters);

/// An agent with the Q-function of a file, under the configuration that it was learned in; refused if it belongs to
/// another task.
Result<std::unique_ptr<Agent>> makeTeacher(const Registry& registry, const TensorFile& file, const Task& task);

/// An environment with its parameters from the configuration.
Result<std::unique_ptr<Environment>> makeEnvironment(const Registry& registry, const Configuration& configuration);

/// Life number `index` (from 0) of the experiment, ready to start.
/// It ends after `mostSteps` steps at the latest.
Result<std::unique_ptr<Life>> makeLife(const Registry& registry, const Configuration& configuration, int index,
                                       bool keepRows,
                                       std::int64_t mostSteps = std::numeric_limits<std::int64_t>::max());

/// A life that was saved goes on: made from the parameters that hold `now` (and `inForce` in the environment), with the
/// tables of now.start and the rest from `archive`.
Result<std::unique_ptr<Life>> resumeLife(const Registry& registry, const Configuration& now,
                                         const Configuration& inForce, bool keepRows,
                                         const std::vector<Change>& changes, Archive& archive);

}  // namespace surefoot
