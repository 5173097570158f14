// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/basics/result.h"

namespace surefoot {

/// The bytes of a regular file, or a sentence that says why there are none.
Result<std::string> readFile(const std::string& path);

/// The same for a text of at most 64 MB.
Result<std::string> readText(const std::string& path);
/// No more than the first bytes.
Result<std::string> readHead(const std::string& path, std::size_t most);

/// "q.safetensors: …" as an error of kind File.
Error fileError(const std::string& name, const std::string& sentence);

}  // namespace surefoot
