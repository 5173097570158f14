// SPDX-License-Identifier: GPL-3.0-or-later
// The formula in which every parameter stands, in plain text and in one notation, as in a book's list of symbols. Shown
// by tooltips and `surefoot list`.
#pragma once

#include <string>

#include "core/parameters.h"

namespace surefoot {

/// "π(a) = exp(Q(s, a)/τ) / Σ_b exp(Q(s, b)/τ)"; "" for a parameter that is not known here, which a test forbids.
std::string formulaOf(const Parameter& parameter);

}  // namespace surefoot
