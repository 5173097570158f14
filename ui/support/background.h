// SPDX-License-Identifier: GPL-3.0-or-later
// One piece of work at a time on a thread of its own, so that the window goes on meanwhile. New work replaces the old:
// the old work is told to stop, and the new work begins when it has stopped.
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "ui/support/call_queue.h"

namespace surefoot {

class Background final : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr) : QObject(parent) {}
  /// Waits for the work in hand to stop.
  ~Background() override;

  /// Runs `work` on the thread, then `then` on the window's, unless it was cancelled meanwhile. Work that takes less
  /// than `patience` is waited for: then both are done when this returns. Whatever `work` throws ends it alone, and
  /// failed() tells, in place of `then`.
  void start(std::function<void(const std::atomic<bool>& interrupted)> work, std::function<void()> then,
             std::chrono::milliseconds patience = std::chrono::milliseconds(0));
  void cancel();
  bool busy() const { return running_ || next_; }

 Q_SIGNALS:
  void busyChanged();
  void failed(const QString& sentence);  ///< work or `then` threw; `then` was not called, or not to its end

 private:
  struct Job {
    std::function<void(const std::atomic<bool>&)> work;
    std::function<void()> then;
    std::atomic<bool> interrupted{false};
    std::promise<void> done;
    QString trouble{};  ///< what `work` threw
  };
  void run(std::shared_ptr<Job> job);
  void finished(const std::shared_ptr<Job>& job);

  std::shared_ptr<Job> running_, next_;
  CallQueue calls_;
  std::thread thread_;
};

}  // namespace surefoot
