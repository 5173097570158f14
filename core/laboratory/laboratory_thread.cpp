// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/laboratory_thread.h"

#include <chrono>

#include "core/basics/guarded_call.h"

namespace surefoot {

namespace {
using Clock = std::chrono::steady_clock;
constexpr auto kFirstLook = std::chrono::seconds(1);
constexpr int kShareOfLooks = 10;  // measuring takes at most this part of the time: 1/kShareOfLooks
}  // namespace

Result<LabView> viewOf(const Registry& registry, const Store& store) {
  auto plan = store.plan();
  if (!plan) return plan.error();
  auto evidence = readEvidence(registry, store);
  if (!evidence) return evidence.error();
  LabView view{.evidence = std::move(*evidence), .findings = {}};
  view.findings = findingsOf(std::move(*plan), view.evidence);
  return view;
}

LaboratoryThread::LaboratoryThread(const Registry& registry, Plan plan, Store store, const LabOptions& options)
    : registry_(registry),
      plan_(std::move(plan)),
      thread_([this, options, store = std::move(store)]() mutable {
        const std::string trouble = troubleOf([&] { run(std::move(store), options); });
        if (!trouble.empty()) {
          const std::lock_guard lock(mutex_);
          trouble_ = trouble;
        }
        over_ = true;
      }) {}

LaboratoryThread::~LaboratoryThread() {
  stop();
  thread_.join();
}

LabProgress LaboratoryThread::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

std::shared_ptr<const LabView> LaboratoryThread::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

std::string LaboratoryThread::trouble() const {
  const std::lock_guard lock(mutex_);
  return trouble_;
}

void LaboratoryThread::look(const Store& store) {
  auto view = viewOf(registry_, store);
  const std::lock_guard lock(mutex_);
  if (view)
    view_ = std::make_shared<const LabView>(std::move(*view));
  else
    trouble_ = view.error().message;
}

void LaboratoryThread::run(Store store, LabOptions options) {
  auto next = Clock::now() + kFirstLook;
  int seen = 0;  // lives of this run
  options.interrupted = &interrupted_;
  options.paused = &paused_;
  options.progress = [&](const LabProgress& p) {
    const std::lock_guard lock(mutex_);
    progress_ = p;
  };
  options.look = [&](const Store& s) {
    const auto before = Clock::now();
    const int done = progress().work.livesDone;
    if (before < next || done == seen) return;
    look(s);
    seen = done;
    next = Clock::now() + std::max<Clock::duration>(kFirstLook, kShareOfLooks * (Clock::now() - before));
  };
  const auto result = runPlan(registry_, plan_, store, options);
  if (result) {
    complete_ = result->complete();
    if (!interrupted_) look(store);  // when interrupted, the results are not needed
  }
  {
    const std::lock_guard lock(mutex_);
    if (!result)
      trouble_ = result.error().message;
    else if (!result->keeping)
      trouble_ = result->keeping.error().message;
  }
}

}  // namespace surefoot
