// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about many systems ([systems] of a plan): each is judged on every system alone, and what is told is the share
// of the systems in which it holds. Agrees: in three quarters or more; differs: not in a quarter or more.
#pragma once

#include <set>

#include "core/recipes/claim.h"

namespace surefoot {

inline constexpr double kOfMostSystems = 0.75;

/// The numbers of the systems that conditions are of; empty: of none.
std::set<int> systemsOf(const std::vector<Evidence>& evidence);

/// `ours` is the share of the systems that agree; the note counts and names the others.
Result<Judgement> judgeOnSystems(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence,
                                 const std::set<int>& systems, std::uint64_t seed);

}  // namespace surefoot
