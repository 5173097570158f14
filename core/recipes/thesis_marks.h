// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's numbers beside ours: where its claims about a measure put the bars of a figure.
#pragma once

#include "core/recipes/claim.h"
#include "core/recipes/figure.h"

namespace surefoot {

/// Sets FigureSeries::thesis for every bar that a claim of kind `value` or `reduction` gives a number for. A reduction
/// is a percentage of the reference: it is marked relative to the mean of our reference, because the thesis's falls are
/// from another robot. Curves are left alone.
void markThesis(Figure& figure, const std::string& measure, const std::vector<Claim>& claims,
                const std::vector<Evidence>& evidence);

}  // namespace surefoot
