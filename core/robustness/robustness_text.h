// SPDX-License-Identifier: GPL-3.0-or-later
// What robustness was found, as text: for other programs and for people. Any thread.
#pragma once

#include <string>

#include "core/robustness/robustness.h"

namespace surefoot {

/// One object, in a line: what was asked, and a list of cells.
std::string robustnessAsJson(const Robustness& robustness);
/// A row a cell.
std::string robustnessAsCsv(const Robustness& robustness);
/// Falls, and successes where the task has them: models as rows, pushes as columns, two functions beside each other.
std::string robustnessAsTable(const Robustness& robustness);

/// "100 starts a cell, pushed between 0 and 5 s, followed for 10 s, policy greedy, seed 1"
std::string robustnessConditions(const RobustnessPlan& plan);
/// "12 of 100 fell, 12 % (95 %: 7 … 20 %)"; successes if nothing can fall.
std::string cellText(const RobustnessPlan& plan, const Tally& tally);

}  // namespace surefoot
