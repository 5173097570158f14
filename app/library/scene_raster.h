// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of a world as pixels, painted by Cairo in the light colours of the window.
#pragma once

#include <cstdint>

#include "core/basics/result.h"
#include "core/scene.h"

namespace surefoot {

inline constexpr int kSmallestPicture = 16, kLargestPicture = 4096;  ///< [px], either side

/// rgb[height][width][3] ← the scene, its focus in the middle.
Status paintInto(const Scene& scene, int width, int height, std::uint8_t* rgb);

}  // namespace surefoot
