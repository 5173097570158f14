// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "core/text/printable.h"
#include "core/text/text.h"
#include "physics/robot/child/process_start.h"

namespace surefoot {

Result<std::unique_ptr<Process>> Process::start(const std::vector<std::string>& command,
                                                const std::vector<std::string>& environment) {
  const auto made = startProcess(command, environment);
  if (!made) return made.error();
  return std::unique_ptr<Process>(new Process(made->id, made->channel, made->errors));
}

Process::~Process() {
  if (!reaped_) {
    kill(-id_, SIGKILL);
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  close(channel_), close(errors_);
}

bool Process::write(std::span<const std::byte> bytes) {
  constexpr std::chrono::seconds kPatience(5);
  const auto end = Clock::now() + kPatience;
  while (!bytes.empty()) {
    const ssize_t sent = send(channel_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN) && Clock::now() < end) {
      keepErrors();
      continue;
    }
    if (sent <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
  return true;
}

void Process::keepErrors() {
  constexpr std::size_t kMost = 4096;
  constexpr int kPieces = 16;  // of a flood, the rest waits
  std::array<char, 4096> buffer;
  for (int i = 0; i < kPieces; ++i) {
    const ssize_t got = ::read(errors_, buffer.data(), buffer.size());
    if (got <= 0) return;
    lastErrors_.append(buffer.data(), static_cast<std::size_t>(got));
    if (lastErrors_.size() > kMost) lastErrors_.erase(0, lastErrors_.size() - kMost);
  }
}

// A call of the system for an answer that comes soon: the socket's own patience is short, and in between errors are
// read, lest a program that writes many of them waits for us. When the time is over, what has come is looked at once
// more: this process may itself have stood still (Ctrl+Z).
Process::Reading Process::read(std::span<std::byte> bytes, Clock::time_point until,
                               const std::function<bool()>& stopped) {
  while (!bytes.empty()) {
    if (at_ == filled_) {
      const bool late = Clock::now() >= until;
      const ssize_t got = recv(channel_, buffer_.data(), buffer_.size(), late ? MSG_DONTWAIT : 0);
      if (got < 0 && (errno == EINTR || errno == EAGAIN)) {
        keepErrors();
        if (late) return Reading::TimedOut;
        if (stopped && stopped()) return Reading::Stopped;
        continue;
      }
      if (got <= 0) return Reading::Ended;
      at_ = 0, filled_ = static_cast<std::size_t>(got);
    }
    const std::size_t some = std::min(bytes.size(), filled_ - at_);
    std::memcpy(bytes.data(), buffer_.data() + at_, some);
    at_ += some;
    bytes = bytes.subspan(some);
  }
  return Reading::Done;
}

std::string Process::end() {
  int status = 0;
  bool ended = reaped_;
  for (int i = 0; i < 100 && !ended; ++i) {
    ended = waitpid(id_, &status, WNOHANG) == id_;
    if (!ended) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  reaped_ = ended;
  if (ended) kill(-id_, SIGKILL);  // whatever it started itself
  keepErrors();
  std::string_view errors = lastErrors_;
  while (!errors.empty() && std::isspace(static_cast<unsigned char>(errors.back()))) errors.remove_suffix(1);
  constexpr std::size_t kMost = 200;  // the end of a line says what is wrong
  errors.remove_prefix(errors.rfind('\n') + 1);
  const std::string cut = errors.size() > kMost ? "…" : "";
  const std::string last = cut + printable(errors.substr(errors.size() - std::min(errors.size(), kMost)));
  const std::string behind = last.empty() ? "" : fmt::format("; its last words: {}", last);
  if (!ended) return "it closed its output" + behind;
  const int code = WEXITSTATUS(status);
  if (!WIFSIGNALED(status) && code > 128 && code < 160)  // as bubblewrap and shells say it
    return fmt::format("it was killed by the signal {}{}", code - 128, behind);
  if (WIFSIGNALED(status)) return fmt::format("it was killed by the signal {}{}", WTERMSIG(status), behind);
  return fmt::format("it ended with the exit code {}{}", code, behind);
}

}  // namespace surefoot
