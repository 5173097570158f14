// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/process/interrupt.h"

#include <time.h>
#include <unistd.h>

#include <csignal>

#include "app/process/exit_code.h"

namespace surefoot {

namespace {

// A signal handler can reach nothing but globals.
std::atomic<bool> interrupted{false};
std::atomic<time_t> firstSecond{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<time_t>::is_always_lock_free);

void onSignal(int) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  // A shell or `timeout` may send the same signal twice in a row: that is one wish.
  if (interrupted && now.tv_sec > firstSecond + 1) _exit(kInterrupted);
  if (!interrupted) firstSecond = now.tv_sec;
  interrupted = true;
}

}  // namespace

const std::atomic<bool>& watchForInterrupt() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  return interrupted;
}

void reportFailedWrites() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace surefoot
