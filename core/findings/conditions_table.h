// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of a plan side by side, for a report: falls with their 95 % interval and the change against the
// reference, and beside them other measures.
#pragma once

#include "core/findings/findings.h"

namespace surefoot {

struct ConditionsTable {
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;  ///< [condition][head]
};

/// `measures`: from measureNames(). If lives began with the Q-functions of a pool, intervals are over the Q-functions.
ConditionsTable conditionsTable(const Findings& findings, const std::vector<Evidence>& evidence,
                                const std::vector<std::string>& measures);

}  // namespace surefoot
