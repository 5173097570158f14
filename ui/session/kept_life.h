// SPDX-License-Identifier: GPL-3.0-or-later
// A life that was replaced by another one, with all the window's data about it: undo brings it back unchanged.
#pragma once

#include <memory>
#include <optional>

#include "ui/running/known_life.h"
#include "ui/running/looking.h"
#include "ui/running/run_curves.h"

namespace surefoot {

struct KeptLife {
  std::shared_ptr<LifeAside> aside;  ///< null: it was dropped to free memory
  KnownLife known;
  int curve = 0;                    ///< its number among the curves
  std::optional<RunCurves> curves;  ///< the curves of its environment, if the next life is in another one
  SeenFalls seen;

  bool unsaved() const { return aside && known.progress.learnedSince(known.file.saved); }
};

}  // namespace surefoot
