// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about many systems ([systems] of a plan): each is judged on every system alone, and what is told is the share
// of the systems in which it holds. Agrees: in three quarters or more; differs: not in a quarter or more.
#pragma once

#include <map>

#include "core/recipes/claim.h"

namespace surefoot {

inline constexpr double kOfMostSystems = 0.75;

/// The conditions of every system, without its name in theirs. Empty: the conditions are not of systems.
std::map<int, std::vector<Evidence>> bySystem(const std::vector<Evidence>& evidence);

/// `ours` is the share of the systems that agree; the note counts and names the others.
Result<Judgement> judgeOnSystems(const Registry& registry, const Claim& claim,
                                 const std::map<int, std::vector<Evidence>>& systems, std::uint64_t seed);

}  // namespace surefoot
