// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that are pictures of worlds and of tilings.
#pragma once

#include "core/experiment/configuration.h"
#include "core/recipes/figure.h"

namespace surefoot {

/// The environment after one step with its strongest action.
Result<Figure> drawWorld(const Registry& registry, const FigureSpec& spec, const Configuration& c);

/// The tilings of a tile coder over two state variables, in units of tiles; tiles with spec.state in them are filled.
Result<Figure> drawTilings(const Registry& registry, const FigureSpec& spec, const Configuration& c);

/// One row per corner: shape, x, y.
std::string sceneAsCsv(const Scene& scene);

}  // namespace surefoot
