// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers for scales.
#pragma once

namespace surefoot {

/// The least of 1, 2, 5 times a power of ten that is not below the value (> 0).
double niceAbove(double value);

}  // namespace surefoot
