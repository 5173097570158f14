// SPDX-License-Identifier: GPL-3.0-or-later
// A program with a socket at its standard input and output. What it writes to standard error is kept for the sentence
// that tells why it ended. One thread; the thread may change.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

class Process {
 public:
  /// `environment`: "NAME=value". It ends when this process ends, however that comes.
  static Result<std::unique_ptr<Process>> start(const std::vector<std::string>& command,
                                                const std::vector<std::string>& environment);
  /// Ends it at once.
  ~Process();
  Process(const Process&) = delete;

  /// False: it has ended, or does not read.
  bool write(std::span<const std::byte> bytes);
  using Clock = std::chrono::steady_clock;
  enum class Reading { Done, Ended, TimedOut, Stopped };
  /// Fills all of `bytes` until then, or says why not. `stopped`, which may be null, is asked while it waits.
  Reading read(std::span<std::byte> bytes, Clock::time_point until, const std::function<bool()>& stopped = {});
  /// More has been read from it than read() has given away.
  bool saysMore() const { return at_ != filled_; }

  /// "it ended with the exit code 1: ModuleNotFoundError: …"; waits a moment for its end.
  std::string end();
  int id() const { return id_; }

 private:
  Process(int id, int channel, int errors) : id_(id), channel_(channel), errors_(errors) {}
  void keepErrors();

  int id_, channel_, errors_;
  std::array<std::byte, 4096> buffer_;
  std::size_t at_ = 0, filled_ = 0;  ///< of the buffer
  bool reaped_ = false;
  std::string lastErrors_;
};

}  // namespace surefoot
