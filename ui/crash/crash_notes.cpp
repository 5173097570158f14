// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/crash/crash_notes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace surefoot {

namespace {

/// A text that can be read at every moment: another one is complete before it takes its place.
template <std::size_t kMost>
class ReadyText {
 public:
  void set(std::string_view text) {
    const std::size_t next = 1 - shown_;
    lengths_[next] = text.copy(texts_[next].data(), kMost);
    shown_ = next;
  }
  std::string_view get() const {
    const std::size_t now = shown_;
    return {texts_[now].data(), lengths_[now]};
  }

 private:
  std::atomic<std::size_t> shown_{0};
  std::array<std::array<char, kMost>, 2> texts_{};
  std::array<std::size_t, 2> lengths_{};
};

// A signal handler can reach nothing but globals.
constexpr std::size_t kCommands = 30;
ReadyText<4096> reportFile, aboutLines;
ReadyText<16'384> lifeLinesNow;
std::array<ReadyText<120>, kCommands> commandsGiven;  // the newest in the place of the oldest
std::atomic<std::size_t> commandCount{0};
std::atomic<time_t> watchedSince{0};
std::atomic<bool> crashing{false};
std::array<std::byte, 65'536> ownStack;  // for a stack that has no room left
static_assert(std::atomic<std::size_t>::is_always_lock_free && std::atomic<time_t>::is_always_lock_free &&
              std::atomic<bool>::is_always_lock_free);

constexpr int kSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

std::string_view nameOf(int signal) {
  constexpr std::string_view kNames[] = {"SIGSEGV", "SIGBUS", "SIGFPE", "SIGILL", "SIGABRT"};
  for (std::size_t i = 0; i < std::size(kSignals); ++i)
    if (kSignals[i] == signal) return kNames[i];
  return "a signal";
}

time_t secondsNow() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}

void put(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void putNumber(int file, time_t number) {
  std::array<char, 24> digits{};
  std::size_t first = digits.size();
  do digits[--first] = static_cast<char>('0' + number % 10);
  while ((number /= 10) > 0);
  put(file, {digits.data() + first, digits.size() - first});
}

void onCrash(int signal) {
  while (crashing.exchange(true)) pause();  // another thread's report is being written, and then all is over
  const int file = open(reportFile.get().data(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file >= 0) {
    writeCrashReport(file, signal);
    fsync(file);
    close(file);
  }
  std::signal(signal, SIG_DFL);
  raise(signal);  // ends the program when this function is left
}

}  // namespace

void watchForCrashes(const std::string& file, const std::string& about) {
  reportFile.set(file + '\0');
  aboutLines.set(about);
  watchedSince = secondsNow();
  const stack_t stack{.ss_sp = ownStack.data(), .ss_flags = 0, .ss_size = ownStack.size()};
  sigaltstack(&stack, nullptr);
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);  // a crash of the handler ends the program
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

void noteCommand(std::string_view name) {
  const std::size_t number = commandCount;
  commandsGiven[number % kCommands].set(fmt::format("{:8} s  {}\n", secondsNow() - watchedSince, name));
  commandCount = number + 1;
}

void noteLife(std::string_view lines) {
  lifeLinesNow.set(lines);
}

void writeCrashReport(int file, int signal) {
  put(file, "Surefoot was ended by ");
  put(file, nameOf(signal));
  put(file, " after ");
  putNumber(file, secondsNow() - watchedSince);
  put(file, " s.\n\n");
  put(file, aboutLines.get());
  put(file, "\nThe life\n");
  put(file, lifeLinesNow.get());
  put(file, "\nThe last commands\n");
  const std::size_t all = commandCount;
  for (std::size_t i = all < kCommands ? 0 : all - kCommands; i < all; ++i)
    put(file, commandsGiven[i % kCommands].get());
}

}  // namespace surefoot
