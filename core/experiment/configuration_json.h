// SPDX-License-Identifier: GPL-3.0-or-later
// A configuration as JSON, for results and files, and back.
#pragma once

#include <nlohmann/json.hpp>

#include "core/experiment/configuration.h"

namespace surefoot {

/// {environment, preset, scenario, agent, features, policy, parameters: {…}, lives, minutes, episodes, until}.
nlohmann::ordered_json configurationAsJson(const Configuration& configuration);

/// {key: value, …}, a choice by its name.
nlohmann::ordered_json parametersAsJson(const Parameters& parameters);

/// Reads the names and parameters; whatever the JSON holds, every value is checked as if it were typed. `file` is named
/// in messages. Parameters missing in the JSON have their defaults.
Result<Configuration> configurationFromJson(const Registry& registry, const nlohmann::json& json,
                                            const std::string& file);

/// Sets every parameter that `json` names, an object of numbers and names of choices.
Status setParameters(Parameters& parameters, const nlohmann::json& json, const std::string& file);

}  // namespace surefoot
