// SPDX-License-Identifier: GPL-3.0-or-later
// The kinds of files that the program reads and writes: for the manual and completions. The desktop knows them by
// resources/desktop/surefoot-mime.xml.
#pragma once

#include <span>
#include <string_view>

namespace surefoot {

struct FileKind {
  std::string_view name;    ///< "a robot"
  std::string_view ending;  ///< "toml"
  bool opens;               ///< the window opens it
  std::string_view holds;   ///< one sentence without its full stop
};

std::span<const FileKind> fileKinds();

}  // namespace surefoot
