// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a world as JSON (surefoot_environment_draw).
#pragma once

#include <nlohmann/json.hpp>

#include "core/scene.h"

namespace surefoot {

nlohmann::ordered_json sceneAsJson(const Scene& scene);

}  // namespace surefoot
