// SPDX-License-Identifier: GPL-3.0-or-later
// The version of this program's lives. The same configuration and seed give the same bits in all programs with the same
// number. Lives with different numbers do not belong into one result, nor does a life that one version began and
// another continued.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

/// Goes up by one whenever any life takes another course than before: the hashes in tests/core/experiment/
/// determinism_test.cpp change then, and name the number that they belong to.
inline constexpr int kLivesVersion = 1;

/// The number for a file without one: it was written before the number was noted.
inline constexpr int kLivesVersionUnknown = 0;

/// Why a life of another version cannot be continued; `program` is the program's version in its file.
Error otherLives(const std::string& file, int version, const std::string& program);

}  // namespace surefoot
