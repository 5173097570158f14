// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/support/background.h"

#include "core/basics/guarded_call.h"

namespace surefoot {

Background::~Background() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void Background::start(std::function<void(const std::atomic<bool>&)> work, std::function<void()> then,
                       std::chrono::milliseconds patience) {
  auto job = std::make_shared<Job>();
  job->work = std::move(work);
  job->then = std::move(then);
  if (running_) {
    running_->interrupted = true;
    next_ = std::move(job);
    return;
  }
  auto done = job->done.get_future();
  run(job);
  if (done.wait_for(patience) == std::future_status::ready)
    finished(job);
  else
    Q_EMIT busyChanged();
}

void Background::run(std::shared_ptr<Job> job) {
  running_ = job;
  thread_ = std::thread([this, job] {
    job->trouble = QString::fromStdString(troubleOf([&] { job->work(job->interrupted); }));
    job->done.set_value();
    calls_.post([this, job] { finished(job); });
  });
}

void Background::finished(const std::shared_ptr<Job>& job) {
  if (running_ != job) return;  // it was waited for
  thread_.join();
  running_.reset();
  if (next_) {
    run(std::exchange(next_, nullptr));
    return;
  }
  Q_EMIT busyChanged();
  if (job->interrupted) return;
  QString trouble = job->trouble;
  if (trouble.isEmpty()) trouble = QString::fromStdString(troubleOf([&] { job->then(); }));
  if (!trouble.isEmpty()) Q_EMIT failed(trouble);
}

void Background::cancel() {
  next_.reset();
  if (running_) running_->interrupted = true;
}

}  // namespace surefoot

#include "moc_background.cpp"
