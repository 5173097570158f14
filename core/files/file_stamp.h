// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a file has changed, from its entry in the folder alone: nothing of it is read. Any thread.
#pragma once

#include <cstdint>
#include <string>

namespace surefoot {

struct FileStamp {
  std::string identity{};     ///< another one whenever the content may be another; empty: there is no such file
  std::int64_t bytes = 0;     ///< its size
  std::int64_t modified = 0;  ///< [s] since 1970
};

/// A file system notes times in steps of some milliseconds: two changes within one may look like none.
FileStamp stampOf(const std::string& path);

}  // namespace surefoot
