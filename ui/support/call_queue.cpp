// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/call_queue.h"

#include <QCoreApplication>
#include <QEvent>
#include <utility>

namespace surefoot {

void CallQueue::post(std::function<void()> call) {
  {
    const std::lock_guard lock(mutex_);
    calls_.push_back(std::move(call));
  }
  QCoreApplication::postEvent(this, new QEvent(QEvent::User));
}

// An event makes one call: a call that opens a dialog, with an event loop of its own, does not hold up the next.
void CallQueue::customEvent(QEvent*) {
  std::function<void()> call;
  {
    const std::lock_guard lock(mutex_);
    call = std::move(calls_.front());
    calls_.pop_front();
  }
  call();
}

}  // namespace surefoot
