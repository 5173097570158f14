// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace surefoot {

/// The most weights that one table may have, of all actions together: 1 GiB of doubles.
inline constexpr double kMostWeights = 1u << 27;

}  // namespace surefoot
