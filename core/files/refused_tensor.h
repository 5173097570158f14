// SPDX-License-Identifier: GPL-3.0-or-later
// Why a file cannot be used, where one of its tensors is the reason.
#pragma once

#include <string_view>

#include "core/files/tensor_file.h"

namespace surefoot {

/// The program that wrote the file, "0.1.0", if it was not this version.
std::string otherProgramOf(const TensorFile& file);

/// "FILE: the tensor "q.weights" is missing."; of a file that another version wrote also this, and what can be done.
Error refusedTensor(const TensorFile& file, std::string_view tensor, std::string_view why);

}  // namespace surefoot
