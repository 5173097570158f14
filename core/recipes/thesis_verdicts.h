// SPDX-License-Identifier: GPL-3.0-or-later
// The thesis's claims about the falls of single conditions, and whether our lives agree: for the columns of a table.
#pragma once

#include <map>

#include "core/recipes/claim.h"

namespace surefoot {

struct ThesisVerdict {
  std::string says;  ///< "−45 %", "21", "no difference", "differs"
  Verdict verdict = Verdict::Undecided;
  std::vector<std::string> claims;  ///< their ids
};

/// The verdicts by the names of conditions; conditions without a claim are left out. Used are the claims about falls
/// during learning of the kinds value, reduction, significant and no-difference, which are about single conditions;
/// each is judged for one condition at a time.
std::map<std::string, ThesisVerdict> thesisVerdicts(const Registry& registry, const std::vector<Claim>& claims,
                                                    const std::vector<Evidence>& evidence, std::uint64_t seed);

}  // namespace surefoot
