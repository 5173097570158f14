// SPDX-License-Identifier: GPL-3.0-or-later
// Which tensors a Q-function or a checkpoint may have, and their sizes by its own description. This is checked before
// their data is read, so that a file cannot take memory for useless tensors.
#pragma once

#include "core/files/tensor_file.h"

namespace surefoot {

/// The file may be without its data. Kind and format are checked before.
Status checkTensors(const TensorFile& file);

}  // namespace surefoot
