// SPDX-License-Identifier: GPL-3.0-or-later
// What callers say of a world or a life, as JSON, and what is told of a world.
#pragma once

#include <nlohmann/json.hpp>

#include "app/requests/requests.h"
#include "core/experiment/configuration.h"

namespace surefoot {

using OrderedJson = nlohmann::ordered_json;

/// An object with some of these keys; NULL counts as {}. Messages call it `name`.
Result<nlohmann::json> parseDescription(const char* text, const char* name, const std::vector<std::string>& keys);

/// "environment", "preset", "scenario", "agent", "features", "policy".
Result<ChosenNames> namesIn(const nlohmann::json& description);
/// {KEY: number or name}, each as a person would write it.
Result<std::vector<std::string>> assignmentsIn(const nlohmann::json& parameters);
/// A text, a whole number, true or false under a key; nothing where it is missing or null.
Result<std::optional<std::string>> textOf(const nlohmann::json& description, const std::string& key);
Result<std::optional<std::string>> numberOf(const nlohmann::json& description, const std::string& key);
Result<bool> flagOf(const nlohmann::json& description, const std::string& key);

/// The world of a description, and everything that can be set in it. With "programs": true its program may be started.
Result<Configuration> worldIn(const Registry& registry, const char* description);
/// The program of this robot may be started from now on.
void allowProgram(const Registry& registry, const Configuration& configuration);

/// As surefoot.h describes it (surefoot_environment_about).
OrderedJson aboutWorld(const Environment& environment, const Configuration& configuration);

}  // namespace surefoot
