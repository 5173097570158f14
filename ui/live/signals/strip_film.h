// SPDX-License-Identifier: GPL-3.0-or-later
// A film of a world with strips of signals below it, whose cursor goes along.
#pragma once

#include <memory>
#include <vector>

#include "core/signals/footage.h"
#include "core/signals/signal_table.h"
#include "ui/film/film.h"
#include "ui/live/signals/strips.h"

namespace surefoot {

struct Theme;

struct StripsBelow {
  std::shared_ptr<const SignalTable> table;  ///< in which the footage has its rows
  std::vector<Strip> strips;                 ///< empty: nothing stands below
};

/// `footage` is cut for the film. The strips show all of its time, or of a longer one 30 s around the moment.
Film filmOf(std::shared_ptr<const Environment> environment, Footage footage, StripsBelow below, QSize whole,
            const Theme& theme);

}  // namespace surefoot
