// SPDX-License-Identifier: GPL-3.0-or-later
// One linear estimate of a Q-function as C99 text: its features, its weights, and the sum over both
// (core/values/linear_action_value.h).
#pragma once

#include <string>

#include "core/environment.h"
#include "core/files/tensor_file.h"

namespace surefoot {

/// "static void NAME_values(const double s[], double q[]);" with all that it needs but the helpers.
Result<std::string> estimateInC(const TensorFile& file, const std::string& name, const Task& task, bool floats);

/// Bytes of its tables.
double tableBytesOf(const TensorFile& file, const std::string& name, bool floats);

}  // namespace surefoot
