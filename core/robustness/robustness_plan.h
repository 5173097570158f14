// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked about the robustness of Q-functions: a grid of pushes and models, the same for the command and the
// window. Everything is checked here, before anything is lived. Used by one thread.
//
// A model is the robot of the first Q-function with a scenario and values of its environment's parameters; every
// scenario is combined with every value. A second Q-function is tried on the same models.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent.h"
#include "core/experiment/configuration.h"

namespace surefoot {

/// As a person types it; nothing: what stands in brackets.
struct RobustnessQuestion {
  std::optional<std::string> push{};      ///< [0] impulses [N s] (value_list.h)
  std::optional<std::string> pushAt{};    ///< [0..5] the time of the push [s], or between which it is drawn
  std::optional<std::string> seconds{};   ///< [10] followed after the push
  std::optional<std::string> scenario{};  ///< names, or "all" [the model that the file was learned on]
  std::vector<std::string> settings{};    ///< "environment.KEY=VALUES", or "policy.KEY=VALUE"
  std::string policy = "greedy";
  std::optional<std::string> starts{};  ///< [100] trials of a cell
  std::optional<std::string> seed{};    ///< [1]
};

/// A Q-function that is tried. Only read while others try it, too.
struct TriedFunction {
  std::string name;             ///< its file
  Configuration configuration;  ///< that it was learned under
  std::shared_ptr<const TensorFile> file;
  std::unique_ptr<Agent> agent;

  const ActionValueFunction& values() const { return agent->values(); }
};

/// From a Q-function's file (readQFile, checkedQFile).
Result<TriedFunction> makeTried(const Registry& registry, std::string name, std::shared_ptr<const TensorFile> file);

/// A model of the grid.
struct TriedModel {
  std::string title;     ///< "2 Half damping, low friction, friction = 0.05 N m"; "as learned"
  std::string scenario;  ///< its name; empty: the file's
  std::vector<std::pair<std::string, double>> values{};  ///< of the parameters, the scenario's first
  std::vector<std::string> settings{};                   ///< the grid's parameters as text, in the order of `keys`
};

struct RobustnessPlan {
  std::string environment, policy;
  std::vector<double> pushes;  ///< [N s]
  std::vector<TriedModel> models;
  std::vector<std::string> keys;       ///< parameters that have values of the grid
  std::vector<std::string> functions;  ///< names of the Q-functions, one or two
  std::vector<Parameters> policies;    ///< one a function: its policy's parameters
  Configuration robot;                 ///< what the models change
  std::int64_t starts = 100;
  std::uint64_t seed = 1;
  std::int64_t earliest = 0, latest = 0, after = 0;  ///< [steps], see Trial
  std::optional<double> stepTime{};                  ///< [s]
  bool canFall = true, canSucceed = false;
  std::string note{};  ///< what a person should know; empty: nothing

  std::size_t cells() const { return functions.size() * models.size() * pushes.size(); }
  /// The configuration of a model.
  Configuration modelled(const TriedModel& model) const;
};

inline constexpr std::size_t kMostModels = 10'000, kMostCells = 100'000;
inline constexpr std::int64_t kMostTrials = 10'000'000;

Result<RobustnessPlan> makeRobustnessPlan(const Registry& registry, const std::vector<const TriedFunction*>& functions,
                                          const RobustnessQuestion& question);

/// The command that asks the same of these files; it can be copied into a shell.
std::string robustnessCommandLine(const RobustnessQuestion& question, const std::vector<std::string>& files);

}  // namespace surefoot
