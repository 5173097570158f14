// SPDX-License-Identifier: GPL-3.0-or-later
// From numbers to colours. Perceptual and safe for the colour-blind.
#pragma once

#include <QRgb>

namespace surefoot {

/// −1 … 0 … +1: vermilion, paper, blue; in the dark theme the centre is dark. Clamped outside.
QRgb divergingColour(double value, bool dark);

/// 0 … 1: viridis (van der Walt & Smith, matplotlib 1.5, CC0), by interpolation of nine of its colours.
QRgb viridisColour(double value);

}  // namespace surefoot
