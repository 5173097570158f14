// SPDX-License-Identifier: GPL-3.0-or-later
// One piece of work at a time on a thread of its own, so that the window goes on meanwhile.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <thread>

namespace surefoot {

class Background final : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr) : QObject(parent) {}
  /// Ends the work in hand.
  ~Background() override { cancel(); }

  /// Runs `work` on the thread, then `then` on the window's, unless it was cancelled meanwhile. What runs is cancelled
  /// first.
  void start(std::function<void(const std::atomic<bool>& interrupted)> work, std::function<void()> then);
  void cancel();
  bool busy() const { return busy_; }

 Q_SIGNALS:
  void busyChanged();

 private:
  std::atomic<bool> interrupted_{false};
  bool busy_ = false;
  std::uint64_t number_ = 0;
  std::thread thread_;
};

}  // namespace surefoot
