// SPDX-License-Identifier: GPL-3.0-or-later
// The greedy policy of a Q-function as a C99 program that needs nothing: no library, no heap, no <math.h>. With tables
// of double it computes the same numbers as the file's own Q-function, in the same order of additions.
//
//   int policy_action(const double state[]);                       the first action with the greatest value, from 0
//   void policy_action_values(const double state[], double q[]);   q̂(s, ·)
//   const double policy_actions[];                                 the actions in their units
#pragma once

#include <string>
#include <vector>

#include "core/environment.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// A state with the action that belongs to it, for the check inside the C program.
struct KnownAction {
  std::vector<double> state;
  int action = 0;
};

struct CPolicySettings {
  bool floats = false;             ///< tables of float: half as large
  std::vector<KnownAction> known;  ///< compiled with -DPOLICY_SELF_TEST it checks these; empty: no such part
  std::string origin;              ///< a line about where the Q-function comes from
};

/// The largest tables that are written [bytes].
inline constexpr double kMostCTables = 64e6;

/// Bytes of the tables that the program would have.
double tableBytesOf(const TensorFile& file, bool floats);

/// The program's text. `file` is a Q-function of `task`, as readQFile gives it. Refused if its features are unknown, or
/// the tables are larger than kMostCTables.
Result<std::string> policyAsC(const TensorFile& file, const Task& task, const CPolicySettings& settings);

}  // namespace surefoot
