// SPDX-License-Identifier: GPL-3.0-or-later
// Where the rows of lives wait on the disk while the lives go on, so that a log of any length needs no memory. Lives
// write when they like; they are read one after the other. Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

class EpisodeSpool {
 public:
  /// A file without a name in a folder; where none can be made, everything waits in memory.
  explicit EpisodeSpool(const std::string& folder);
  EpisodeSpool(const EpisodeSpool&) = delete;
  EpisodeSpool& operator=(const EpisodeSpool&) = delete;
  ~EpisodeSpool();

  /// Never fails: text that cannot be written to the disk waits in memory.
  void append(int life, std::string text);
  /// Reads all parts until `take` fails: ordered by life, and within a life in the order of append().
  Status read(const std::function<Status(std::string_view part)>& take);

 private:
  struct Part {
    int life = 0;
    std::int64_t from = -1;  ///< in the file; -1: in memory
    std::size_t length = 0;
    std::string text{};
  };

  std::mutex mutex_;
  int descriptor_ = -1;
  std::int64_t end_ = 0;
  std::vector<Part> parts_;
};

}  // namespace surefoot
