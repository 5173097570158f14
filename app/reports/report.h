// SPDX-License-Identifier: GPL-3.0-or-later
// Results as text: JSON, CSV, and a table for people.
#pragma once

#include <string>
#include <vector>

#include "core/experiment/experiment.h"

namespace surefoot {

/// {version, configuration, seed, lives: […]}, ending in a newline.
std::string resultAsJson(const Configuration& configuration, const std::vector<LifeResult>& lives);

/// One row per episode, with a column for the life.
std::string logAsCsv(const std::vector<LifeResult>& lives, std::optional<double> stepTime);
/// The same in parts: its heads, and some rows of a life. `rewinds`: falls may be taken back, which has a column then.
std::string logHeads(const std::vector<TaskMeasure>& measures, bool rewinds);
std::string logRows(int life, const std::vector<EpisodeRow>& rows, const std::vector<TaskMeasure>& measures,
                    std::optional<double> stepTime, bool rewinds);

/// A table for a person: the lives' means with 95 % intervals.
std::string resultAsTable(const Configuration& configuration, const std::vector<LifeResult>& lives);

}  // namespace surefoot
