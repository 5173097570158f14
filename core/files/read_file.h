// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/result.h"

namespace surefoot {

/// The bytes of a regular file, or a sentence that says why there are none.
Result<std::string> readFile(const std::string& path);

/// "q.safetensors: …" as an error of kind File.
Error fileError(const std::string& name, const std::string& sentence);

}  // namespace surefoot
