// SPDX-License-Identifier: GPL-3.0-or-later
// Which lives this program lives. The same configuration and seed give the same bits in every program of one number;
// lives of two numbers do not belong into one result, nor does a life that one began and the other goes on with.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

/// Goes up by one whenever any life takes another course than before: the hashes in tests/core/experiment/
/// determinism_test.cpp change then, and name the number that they belong to.
inline constexpr int kLivesVersion = 1;

/// Of a file that does not say: written before the number was noted.
inline constexpr int kLivesVersionUnknown = 0;

/// Why a file cannot be gone on with that was lived by another version; `program` is what it says of itself.
Error otherLives(const std::string& file, int version, const std::string& program);

}  // namespace surefoot
