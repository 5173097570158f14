// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/background.h"

namespace surefoot {

void Background::start(std::function<void(const std::atomic<bool>&)> work, std::function<void()> then) {
  cancel();
  interrupted_ = false;
  busy_ = true;
  const std::uint64_t number = ++number_;
  thread_ = std::thread([this, number, work = std::move(work), then = std::move(then)] {
    work(interrupted_);
    QMetaObject::invokeMethod(
        this,
        [this, number, then] {
          if (number != number_ || interrupted_) return;
          thread_.join();
          busy_ = false;
          Q_EMIT busyChanged();
          then();
        },
        Qt::QueuedConnection);
  });
  Q_EMIT busyChanged();
}

void Background::cancel() {
  if (!thread_.joinable()) return;
  interrupted_ = true;
  thread_.join();
  busy_ = false;
  Q_EMIT busyChanged();
}

}  // namespace surefoot
