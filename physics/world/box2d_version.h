// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the Box2D that is loaded.
#pragma once

#include <box2d/b2_common.h>

#include <string>

namespace surefoot {

inline std::string box2dVersion() {
  return std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
         std::to_string(b2_version.revision);
}

}  // namespace surefoot
