// SPDX-License-Identifier: GPL-3.0-or-later
// From the texts that were given to checked requests. Every value is converted by the parsers of core/parameters.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command_line.h"

namespace surefoot {

/// The options of `train` and `window`, as they were written.
struct TrainOptions {
  Names names;
  std::vector<std::string> assignments;
  std::optional<std::string> seed, minutes, episodes, lives, jobs, log;
  bool json = false, turbo = false;
};

/// The options of `probabilities`, as they were written.
struct ProbabilitiesOptions {
  std::optional<std::string> q;
  std::string policy = "epsilon-greedy";
  std::vector<std::string> assignments;
  bool json = false;
};

Result<TrainRequest> makeTrainRequest(const Registry& registry, const TrainOptions& options, bool window);
Result<ProbabilitiesRequest> makeProbabilitiesRequest(const Registry& registry, const ProbabilitiesOptions& options);

}  // namespace surefoot
