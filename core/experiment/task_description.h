// SPDX-License-Identifier: GPL-3.0-or-later
// What a file says of the task that it was learned in.
#pragma once

#include "core/environment.h"
#include "core/files/tensor_file.h"

namespace surefoot {

Json stateAsJson(const Task& task);
Json actionsAsJson(const Task& task);

/// Whether what is stored belongs to the task: the first difference, with both values.
Status checkTask(const TensorFile& file, const Task& task);

}  // namespace surefoot
