// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's numbers beside ours: where its claims about a measure put the bars of a figure.
#pragma once

#include "core/recipes/claim.h"
#include "core/recipes/figure.h"

namespace surefoot {

/// Sets FigureSeries::thesis for every bar that a claim of kind `value` or `reduction` gives a number for. A reduction
/// is a percentage of the reference: its mark is that share of our reference's mean, since the thesis's falls are those
/// of another robot. Curves are left alone.
void markThesis(Figure& figure, const std::string& measure, const std::vector<Claim>& claims,
                const std::vector<Evidence>& evidence);

}  // namespace surefoot
