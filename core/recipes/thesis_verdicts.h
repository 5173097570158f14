// SPDX-License-Identifier: GPL-3.0-or-later
// What the thesis says of the falls of single conditions, and whether ours bear it out: for the columns of a table.
#pragma once

#include <map>

#include "core/recipes/claim.h"

namespace surefoot {

struct ThesisVerdict {
  std::string says;  ///< "−45 %", "21", "no difference", "differs"
  Verdict verdict = Verdict::Undecided;
  std::vector<std::string> claims;  ///< their ids
};

/// By the names of conditions; those of which the thesis says nothing are not there. Of the claims about falls during
/// learning, those of the kinds value, reduction, significant and no-difference bear on single conditions; each is
/// judged for the one condition.
std::map<std::string, ThesisVerdict> thesisVerdicts(const Registry& registry, const std::vector<Claim>& claims,
                                                    const std::vector<Evidence>& evidence, std::uint64_t seed);

}  // namespace surefoot
