// SPDX-License-Identifier: GPL-3.0-or-later
// Turns the given texts into checked requests. Every value is converted by the parsers of core/parameters.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/requests/command_line.h"
#include "core/saved/stored_function.h"

namespace surefoot {

/// The names that were chosen; nothing where an option was not given.
struct ChosenNames {
  std::optional<std::string> environment, preset, scenario, agent, features, policy;
};
/// The chosen names, and the missing ones from `otherwise`.
Names namesOr(const ChosenNames& chosen, const Names& otherwise);

/// The options of `train` and `window`, as they were written.
struct TrainOptions {
  ChosenNames names;
  std::vector<std::string> assignments;
  std::optional<std::string> seed, minutes, episodes, until, lives, jobs, log, load;
  std::vector<std::string> at;
  bool json = false, turbo = false, otherVersion = false, loadFromOther = false;
  bool openEnded = false;  ///< no length is needed: whoever runs the life says when it is enough
  std::optional<std::string> from;
  std::optional<std::string> save, journal, checkpoint, every, resume;  ///< `train` only
};

/// The options of `probabilities`, as they were written.
struct ProbabilitiesOptions {
  std::optional<std::string> q;
  std::string policy = "epsilon-greedy";
  std::vector<std::string> assignments;
  bool json = false;
};

/// KEY=VALUE, each key once.
Result<std::vector<Assignment>> parseAssignments(const std::vector<std::string>& texts);
/// A whole number from 1 to `most`.
Result<std::int64_t> parseCount(const std::string& option, const std::string& text, std::int64_t most);

/// An error for a key of a policy that is not chosen: it would have no effect.
Status checkPolicyKeys(const Registry& registry, const std::string& policy, const std::vector<Assignment>& assignments);

/// What can be done about lives of another version.
inline constexpr const char* kOtherVersion = "--other-version goes on all the same.";
/// An error about lives of another version, with what can be done about it.
Error orOtherVersion(const Error& error);

/// The policy of a stored function, or another one, with some values on top (KEY=VALUE, of the policy only), ready to
/// be asked.
Result<std::unique_ptr<Policy>> policyOn(const Registry& registry, const StoredFunction& function,
                                         const std::string& policy, const std::vector<std::string>& assignments);

Result<TrainRequest> makeTrainRequest(const Registry& registry, const TrainOptions& options, bool window);
Result<ProbabilitiesRequest> makeProbabilitiesRequest(const Registry& registry, const ProbabilitiesOptions& options);

}  // namespace surefoot
