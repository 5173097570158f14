// SPDX-License-Identifier: GPL-3.0-or-later
// A life that gave way to another one, with everything that the window knew of it: undo brings it back as it was.
#pragma once

#include <memory>
#include <optional>

#include "ui/session/known_life.h"
#include "ui/session/looking.h"
#include "ui/session/run_curves.h"

namespace surefoot {

struct KeptLife {
  std::shared_ptr<LifeAside> aside;  ///< null: it had to make room for others
  KnownLife known;
  int curve = 0;                    ///< its number among the curves
  std::optional<RunCurves> curves;  ///< those beside it, where the life after it is in another environment
  SeenFalls seen;

  bool unsaved() const { return aside && known.progress.learnedSince(known.file.saved); }
};

}  // namespace surefoot
