// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters that several representations share: their resolution, per variable and as a whole.
#pragma once

#include <string>

#include "core/environment.h"

namespace surefoot {

/// The most weights that one table may have, for all actions together: 1 GiB of doubles.
inline constexpr double kMostWeights = 1u << 27;

/// "pole angle" → "Pole angle".
std::string capitalised(std::string title);

/// "From α", "From column": a word and the variable that it is about, short.
std::string shortLabel(const std::string& word, const StateVariable& variable);

/// The resolution of a variable: how many of something per span.
Parameter resolutionParameter(const StateVariable& variable, std::string help, std::string origin);
/// A factor that multiplies numbers chosen one by one.
Parameter factorParameter(std::string key, std::string title, std::string help, std::string origin);

}  // namespace surefoot
