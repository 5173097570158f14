// SPDX-License-Identifier: GPL-3.0-or-later
// The description of a task in files that were learned in it.
#pragma once

#include "core/environment.h"
#include "core/files/tensor_file.h"

namespace surefoot {

Json stateAsJson(const Task& task);
Json actionsAsJson(const Task& task);

/// Whether a stored description fits the task; the error names the first difference, with both values.
Status checkTask(const TensorFile& file, const Task& task);

}  // namespace surefoot
