// SPDX-License-Identifier: GPL-3.0-or-later
// Calls that other threads leave for the thread of the window, which makes them from its event loop, in their order.
// As QMetaObject::invokeMethod does it, but with a lock of our own: a thread sanitizer sees that one call ends before
// the other begins, which it cannot see in a Qt that was built without it.
#pragma once

#include <QObject>
#include <deque>
#include <functional>
#include <mutex>

namespace surefoot {

class CallQueue final : public QObject {
 public:
  /// From any thread. A call that has not been made when the queue is destroyed is never made; whoever owns the queue
  /// ends the threads that know it first.
  void post(std::function<void()> call);

 protected:
  void customEvent(QEvent* event) override;

 private:
  std::mutex mutex_;
  std::deque<std::function<void()>> calls_;
};

}  // namespace surefoot
