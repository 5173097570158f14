// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/process_start.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/keyctl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/time.h>
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
    syscall(SYS_keyctl, KEYCTL_JOIN_SESSION_KEYRING, nullptr);  // programs do not see a person's keys
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

Result<StartedProcess> startProcess(const std::vector<std::string>& command,
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
  return StartedProcess{id, channel[0], errors[0]};
}

}  // namespace surefoot
