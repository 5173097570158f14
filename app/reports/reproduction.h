// SPDX-License-Identifier: GPL-3.0-or-later
// One recipe run and judged, and the report on all of them.
#pragma once

#include <string>
#include <vector>

#include "core/findings/conditions_table.h"
#include "core/laboratory/laboratory.h"
#include "core/recipes/recipe.h"

namespace surefoot {

/// The results of one recipe.
struct Reproduced {
  std::string name{}, title{};
  std::vector<std::string> figures{};  ///< files without their ending, relative to the output folder
  std::vector<std::string> captions{};
  ConditionsTable table{};                ///< the table of the recipe's own conditions
  std::vector<Judgement> judgements{};    ///< on the recipe's own conditions
  std::vector<Judgement> onLabPreset{};   ///< the calibrated claims, judged on the lab preset
  std::vector<std::string> calibrated{};  ///< ids of the calibrated claims
  std::string preset = "thesis";          ///< of the recipe's own conditions
  /// Content of the stores, as `experiment` prints it: the recipe's own conditions, and those on the lab preset.
  std::string content{}, labContent{};
  int lives = 0, conditions = 0;
  double seconds = 0;
};

/// Runs a recipe into FOLDER/NAME, or continues it: a store, one CSV per figure, pictures if `draw` makes them, and
/// claims.json.
Result<Reproduced> reproduce(const Registry& registry, const std::string& recipePath, const std::string& folder,
                             const PlanChanges& changes, const LabOptions& lab, bool otherVersion,
                             const std::function<Status(const Figure&, const std::string& folder)>& draw);

/// {id, recipe, preset, thesis, ours, low, high, p, verdict, …} of every claim.
std::string claimsAsJson(const std::vector<Reproduced>& recipes);

/// FOLDER/report.md, report.html (which holds its pictures) and claims.json.
/// A report that somebody else wrote is not replaced.
Status checkReportPlace(const std::string& folder);
Status writeReport(const std::vector<Reproduced>& recipes, const std::string& folder, bool pictures);

}  // namespace surefoot
