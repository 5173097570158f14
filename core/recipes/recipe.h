// SPDX-License-Identifier: GPL-3.0-or-later
// A recipe: a plan, the figures to draw from its results, and the claims of the thesis to test with them. It is one
// TOML file: a plan with [[figure]] and [[claim]] blocks. At the top are the lists `shows`, the thesis's figures and
// tables, `table`, the measures that the table of its conditions has besides the falls, and `apart = true` for what
// takes so long that "all" leaves it out. For the list in the window
// there are `answers`, its question in a sentence, and `minutes_on_two_cores`, how long it took with
// `minutes_for_lives` lives per condition.
#pragma once

#include "core/plans/plan.h"
#include "core/recipes/claim.h"
#include "core/recipes/figure.h"

namespace surefoot {

struct Recipe {
  std::string name;                ///< name of its file
  std::vector<std::string> shows;  ///< "4.4", "table 4.2"
  std::vector<std::string> table;  ///< names from measureNames(), for the plan's tasks
  Plan plan;
  std::vector<FigureSpec> figures;
  std::vector<Claim> claims;

  bool calibrated() const;  ///< some claim is judged on the lab preset, too
};

/// What a recipe says of itself at its top.
struct RecipeHead {
  std::vector<std::string> shows;  ///< the figures and tables of the thesis, by their names there
  bool apart = false;              ///< it takes long, and is run by its own name only
};
Result<RecipeHead> recipeHead(const std::string& path);

/// Reads a recipe from text; messages name `path`. A plan without figures and claims is a recipe, too.
Result<Recipe> parseRecipe(const Registry& registry, const std::string& text, const std::string& path,
                           const PlanChanges& changes);
Result<Recipe> readRecipe(const Registry& registry, const std::string& path, const PlanChanges& changes);

/// The part of the plan that the calibrated claims need, on the lab preset.
Result<Recipe> onLabPreset(const Registry& registry, const std::string& path, const PlanChanges& changes);

}  // namespace surefoot
