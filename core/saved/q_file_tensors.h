// SPDX-License-Identifier: GPL-3.0-or-later
// Which tensors a Q-function or a checkpoint has, and how large they are by its own description: checked before their
// data is read, so that a file cannot take memory for what nobody asked for.
#pragma once

#include "core/files/tensor_file.h"

namespace surefoot {

/// The file may be without its data. Kind and format are checked before.
Status checkTensors(const TensorFile& file);

}  // namespace surefoot
