// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a world across the library's border.
#pragma once

#include <fmt/format.h>

#include "app/library/surefoot.h"
#include "core/environment.h"

namespace surefoot {

inline surefoot_outcome outcomeOf(const Outcome& o) {
  return {.reward = o.reward,
          .terminated = o.ending == Ending::Terminal,
          .truncated = o.ending == Ending::Truncated,
          .fall = o.event == Event::Fall,
          .success = o.event == Event::Success};
}

inline Status checkAction(const Task& task, std::int64_t action) {
  const auto actions = static_cast<std::int64_t>(task.actions.size());
  if (action >= 0 && action < actions) [[likely]]
    return Done{};
  return Error{fmt::format("action: {} is not allowed; it goes from 0 to {}.", action, actions - 1)};
}

inline Status checkPush(double impulse) {
  constexpr double kMost = 1000;  // [N s], as on the command line
  if (impulse >= -kMost && impulse <= kMost) return Done{};
  return Error{fmt::format("push: {} is not allowed; it goes from {} to {} N s.", impulse, -kMost, kMost)};
}

}  // namespace surefoot
