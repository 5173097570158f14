// SPDX-License-Identifier: GPL-3.0-or-later
// Examples of every command, shown by `--help` and in the manual pages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surefoot {

struct Example {
  std::string line;  ///< "surefoot train --minutes 9"
  std::string does;  ///< what it does, without a full stop
};

std::vector<Example> examplesOf(std::string_view command);

/// "Examples:", and two lines an example; empty: there is none.
std::string examplesText(std::string_view command);

}  // namespace surefoot
