// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <future>
#include <mutex>
#include <queue>
#include <thread>

#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

using Clock = std::chrono::steady_clock;

/// Starts all programs on one thread that lives as long as this process: a program that wants to end with its parent
/// ends with the thread that started it.
class Starter {
 public:
  int call(std::function<int()> start) {
    std::packaged_task<int()> task(std::move(start));
    auto result = task.get_future();
    {
      const std::lock_guard lock(mutex_);
      tasks_.push(std::move(task));
    }
    wake_.notify_one();
    return result.get();
  }
  static Starter& only() {
    static Starter* starter = new Starter;  // never ends
    return *starter;
  }

 private:
  Starter() {
    std::thread([this] { run(); }).detach();
  }
  void run() {
    for (;;) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return !tasks_.empty(); });
      auto task = std::move(tasks_.front());
      tasks_.pop();
      lock.unlock();
      task();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::queue<std::packaged_task<int()>> tasks_;
};

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
  all.push_back(nullptr);
  return all;
}

/// The error number, or 0 with the program's id.
int spawn(const std::vector<std::string>& command, const std::vector<std::string>& environment, int channel, int errors,
          int& id) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, channel, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, channel, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);  // Ctrl+C in a terminal is for us
  sigset_t none, all;
  sigemptyset(&none), sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  const int error = posix_spawnp(&id, command.front().c_str(), &files, &attributes, pointers(command).data(),
                                 pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

Result<std::unique_ptr<Process>> Process::start(const std::vector<std::string>& command,
                                                const std::vector<std::string>& environment) {
  std::array<int, 2> channel{}, errors{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel.data()) != 0)
    return Error{fmt::format("no socket: {}", std::strerror(errno))};
  if (pipe2(errors.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    close(channel[0]), close(channel[1]);
    return Error{fmt::format("no pipe: {}", std::strerror(errno))};
  }
  int id = 0;
  const int error = Starter::only().call([&] {
    fcntl(errors[1], F_SETFL, 0);  // the program's end blocks
    return spawn(command, environment, channel[1], errors[1], id);
  });
  close(channel[1]), close(errors[1]);
  if (error != 0) {
    close(channel[0]), close(errors[0]);
    return Error{
        fmt::format("\"{}\" cannot be started: {}", printable(shortened(command.front())), std::strerror(error))};
  }
  constexpr timeval kLook{.tv_sec = 0, .tv_usec = 20'000};
  setsockopt(channel[0], SOL_SOCKET, SO_RCVTIMEO, &kLook, sizeof kLook);
  setsockopt(channel[0], SOL_SOCKET, SO_SNDTIMEO, &kLook, sizeof kLook);
  return std::unique_ptr<Process>(new Process(id, channel[0], errors[0]));
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
  std::array<char, 4096> buffer;
  for (ssize_t got = 0; (got = ::read(errors_, buffer.data(), buffer.size())) > 0;) {
    lastErrors_.append(buffer.data(), static_cast<std::size_t>(got));
    if (lastErrors_.size() > kMost) lastErrors_.erase(0, lastErrors_.size() - kMost);
  }
}

// A call of the system for an answer that comes soon: the socket's own patience is short, and in between errors are
// read, lest a program that writes many of them waits for us.
Process::Reading Process::read(std::span<std::byte> bytes, std::chrono::milliseconds patience) {
  const auto end = Clock::now() + patience;
  while (!bytes.empty()) {
    if (at_ == filled_) {
      const ssize_t got = recv(channel_, buffer_.data(), buffer_.size(), 0);
      if (got < 0 && (errno == EINTR || errno == EAGAIN)) {
        keepErrors();
        if (Clock::now() >= end) return Reading::TimedOut;
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
  const std::string last = printable(shortened(errors.substr(errors.rfind('\n') + 1)));
  const std::string behind = last.empty() ? "" : fmt::format("; its last words: {}", last);
  if (!ended) return "it closed its output" + behind;
  const int code = WEXITSTATUS(status);
  if (!WIFSIGNALED(status) && code > 128 && code < 160)  // as bubblewrap and shells say it
    return fmt::format("it was killed by the signal {}{}", code - 128, behind);
  if (WIFSIGNALED(status)) return fmt::format("it was killed by the signal {}{}", WTERMSIG(status), behind);
  return fmt::format("it ended with the exit code {}{}", code, behind);
}

}  // namespace surefoot
