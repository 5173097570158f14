// SPDX-License-Identifier: GPL-3.0-or-later
// A recipe: a plan, what to draw of its results, and which claims of the thesis they are held against. One TOML file:
// a plan with [[figure]] and [[claim]] blocks and, at the top, the list `shows` of the thesis's figures and tables, and
// `table` of the measures that stand in the table of its conditions beside the falls; `answers`, its question in a
// sentence, and `minutes_on_two_cores`, how long it took with `minutes_for_lives` lives a condition, for the list in
// the window.
#pragma once

#include "core/plans/plan.h"
#include "core/recipes/claim.h"
#include "core/recipes/figure.h"

namespace surefoot {

struct Recipe {
  std::string name;                ///< of its file
  std::vector<std::string> shows;  ///< "4.4", "table 4.2"
  std::vector<std::string> table;  ///< of measureNames()
  Plan plan;
  std::vector<FigureSpec> figures;
  std::vector<Claim> claims;

  bool calibrated() const;  ///< some claim is judged on the lab preset, too
};

/// What the thesis calls that which a recipe shows: figures and tables.
Result<std::vector<std::string>> recipeShows(const std::string& path);

/// From a text; `path` is named in messages. A plan without figures and claims is a recipe, too.
Result<Recipe> parseRecipe(const Registry& registry, const std::string& text, const std::string& path,
                           const PlanChanges& changes);
Result<Recipe> readRecipe(const Registry& registry, const std::string& path, const PlanChanges& changes);

/// The part of the plan that the calibrated claims need, on the lab preset.
Result<Recipe> onLabPreset(const Registry& registry, const std::string& path, const PlanChanges& changes);

}  // namespace surefoot
