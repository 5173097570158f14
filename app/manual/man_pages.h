// SPDX-License-Identifier: GPL-3.0-or-later
// The manual: surefoot(1), surefoot-COMMAND(1) and surefoot-parameters(7), made from the declarations of the command
// line and of the parameters.
#pragma once

#include <string>
#include <vector>

#include "core/registry.h"

namespace surefoot {

struct ManualFile {
  std::string name;  ///< "surefoot-train.1"
  std::string text;
};

/// surefoot(1) and a page for every command. `date`: "2026-11-30".
std::vector<ManualFile> commandPages(const Registry& registry, const std::string& date);

/// surefoot-parameters(7): everything that `surefoot list` names.
ManualFile parametersPage(const Registry& registry, const std::string& date);

}  // namespace surefoot
