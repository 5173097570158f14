// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment on threads of its own, for a window: it runs the missing lives of a plan into a store, and now and then
// measures the results so far. It can pause and go on; when stopped, it keeps unfinished lives beside the store.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "core/findings/findings.h"
#include "core/laboratory/laboratory.h"

namespace surefoot {

/// The results so far.
struct LabView {
  std::vector<Evidence> evidence;
  Findings findings;
};

/// Reads a whole store.
Result<LabView> viewOf(const Registry& registry, const Store& store);

/// All calls belong to one thread, the window's.
class LaboratoryThread {
 public:
  /// Begins at once. The store belongs to the plan, and to this object from now on.
  LaboratoryThread(const Registry& registry, Plan plan, Store store, const LabOptions& options);
  /// Waits until everything stands still and unfinished lives are kept.
  ~LaboratoryThread();
  LaboratoryThread(const LaboratoryThread&) = delete;

  LabProgress progress() const;
  /// The newest results; nullptr: none yet.
  std::shared_ptr<const LabView> view() const;
  /// Lives stand still between two steps, and go on.
  void setPaused(bool paused) { paused_ = paused; }
  /// Ends it soon: unfinished lives are kept beside the store, so that a later run can continue them.
  void stop() { interrupted_ = true; }
  /// Nothing runs any more: all lives are lived, or it was stopped, or failed.
  bool over() const { return over_; }
  bool complete() const { return complete_; }
  /// Why it failed, or empty.
  std::string trouble() const;

 private:
  void run(Store store, LabOptions options);
  void look(const Store& store);

  const Registry& registry_;
  const Plan plan_;
  std::atomic<bool> interrupted_{false}, paused_{false}, over_{false}, complete_{false};
  mutable std::mutex mutex_;  // guards the members below
  LabProgress progress_;
  std::shared_ptr<const LabView> view_;
  std::string trouble_;
  std::thread thread_;
};

}  // namespace surefoot
