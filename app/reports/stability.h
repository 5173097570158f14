// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts under several master seeds: a verdict that changes with the seed is none.
#pragma once

#include "app/reports/reproduction.h"

namespace surefoot {

/// What came out under one master seed.
struct OfSeed {
  std::uint64_t seed = 1;
  std::vector<Reproduced> recipes;
};

/// A row for each claim: its verdict under each seed (a, d, u), and the share of the most frequent one.
std::string stabilityAsMarkdown(const std::vector<OfSeed>& seeds);
std::string stabilityAsJson(const std::vector<OfSeed>& seeds);

}  // namespace surefoot
