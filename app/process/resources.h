// SPDX-License-Identifier: GPL-3.0-or-later
// Plans and recipes that come with the program: in resources/ beside the program or libsurefoot.so in a build tree, in
// share/surefoot/ when it is installed.
#pragma once

#include <string>
#include <vector>

#include "core/basics/result.h"
#include "core/registry.h"

namespace surefoot {

/// A folder of the program's resources, e.g. "plans"; empty if it is not there.
std::string resourceFolder(const std::string& name);
/// The names of the plans that are there, in order.
std::vector<std::string> shippedPlans();
/// The file of a plan: a path, or the name of a shipped one.
Result<std::string> findPlan(const std::string& plan);

/// The names that `reproduce` accepts, in order.
std::vector<std::string> shippedRecipes();

/// A plan or recipe that comes with the program, with its title.
struct ShippedPlan {
  std::string name, title, path;
  bool recipe = false;
  std::vector<std::string> shows{};
  std::string answers{};
  double minutes = 0;  ///< about how long it takes on this machine
};
/// All of them, plans first.
std::vector<ShippedPlan> allShipped(const Registry& registry);
/// The files of recipes: wanted by name, by a figure or table ("4.6", "table 4.2"), or "all"; each once, in order.
Result<std::vector<std::string>> findRecipes(const std::vector<std::string>& wanted);

}  // namespace surefoot
