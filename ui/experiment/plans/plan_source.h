// SPDX-License-Identifier: GPL-3.0-or-later
// A plan, a recipe or results as they stand in a list to choose from.
#pragma once

#include <string>
#include <vector>

namespace surefoot {

struct PlanSource {
  std::string title, path;
  bool recipe = false;
  std::string group{};               ///< the heading above it in the list; empty: plans
  std::string name{};                ///< the name of its file, as `reproduce` takes it: "4.4-4.9"
  std::vector<std::string> shows{};  ///< figures and tables of the thesis: "4.6", "table 4.2"
  std::string answers{};             ///< the question, in a sentence
  double minutes = 0;                ///< the expected time on this machine; 0: unknown
};

}  // namespace surefoot
