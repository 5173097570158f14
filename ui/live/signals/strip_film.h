// SPDX-License-Identifier: GPL-3.0-or-later
// A film with strips of signals below it, whose cursor goes along.
#pragma once

#include <memory>

#include "core/signals/signal_table.h"
#include "ui/film/film.h"
#include "ui/live/signals/strips.h"

namespace surefoot {

struct Theme;

/// The share of a film's height that is the strips'.
inline constexpr double kStripShare = 0.42;

/// The size that the film above has in one of this size with strips.
QSize aboveStrips(QSize whole);
/// `above` has the size aboveStrips(whole). All of the time is shown, or of a longer one 30 s around the moment.
/// `step`: time of a step in the film [s]; rows are steps.
Film withStrips(Film above, QSize whole, std::shared_ptr<const SignalTable> table, std::vector<Strip> strips,
                double step, const Theme& theme);

}  // namespace surefoot
