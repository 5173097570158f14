// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as a person reads them: a true minus sign, thousands separated. For labels, never for files.
#pragma once

#include <string>

namespace surefoot {

/// 3.14159, 2 → "3.14"; −0.001, 2 → "0.00"; never "−0".
std::string fixedText(double value, int decimals);

/// 1234567.0 → "1,234,567".
std::string countText(double value);

}  // namespace surefoot
