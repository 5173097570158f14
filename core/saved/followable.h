// SPDX-License-Identifier: GPL-3.0-or-later
// Which files can be followed: looked at while another process writes them. Any thread.
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

enum class Followable {
  Store,      ///< results of an experiment, to which lives are added
  Checkpoint  ///< a life that is written again and again
};

/// What the file is, by its content; one that is not there yet (or empty), by its name: a checkpoint ends in
/// .safetensors, .surefoot or .ckpt. An error if it is another kind of file, or has no folder to come into.
Result<Followable> followableAt(const std::string& path);

}  // namespace surefoot
