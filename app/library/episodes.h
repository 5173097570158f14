// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of episodes into an array of the caller's.
#pragma once

#include <fmt/format.h>

#include <algorithm>

#include "app/library/surefoot.h"
#include "core/basics/result.h"

namespace surefoot {

/// rows[0 … count − 1] ← episodes `first` … of the `there` ones, as many as there are; `of(i)` makes the row of one.
template <class RowOf>
Status tellEpisodes(std::size_t there, std::size_t first, surefoot_episode* rows, std::size_t count, const RowOf& of) {
  if (!rows && count > 0) return Error{"rows: it is NULL."};
  if (first > there) return Error{fmt::format("first: {} is behind the last of {} episodes.", first, there)};
  const std::size_t last = first + std::min(count, there - first);
  for (std::size_t i = first; i < last; ++i) rows[i - first] = of(i);
  return Done{};
}

}  // namespace surefoot
