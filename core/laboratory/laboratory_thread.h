// SPDX-License-Identifier: GPL-3.0-or-later
// An experiment on threads of its own, for a window: what is missing of a plan is lived into a store, and now and then
// the results so far are measured.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "core/laboratory/findings.h"
#include "core/laboratory/laboratory.h"

namespace surefoot {

/// The results so far.
struct LabView {
  std::vector<Evidence> evidence;
  Findings findings;
};

/// Reads a whole store.
Result<LabView> viewOf(const Store& store);

/// All calls belong to one thread, the window's.
class LaboratoryThread {
 public:
  /// Begins at once. The store belongs to the plan, and to this object from now on.
  LaboratoryThread(const Registry& registry, Plan plan, Store store, int jobs);
  /// Gives up the lives in hand.
  ~LaboratoryThread();
  LaboratoryThread(const LaboratoryThread&) = delete;

  LabProgress progress() const;
  /// The newest results; nullptr: none yet.
  std::shared_ptr<const LabView> view() const;
  /// Gives up the lives in hand; what is over is kept.
  void stop() { interrupted_ = true; }
  /// Nothing runs any more: all lives are lived, or it was stopped, or failed.
  bool over() const { return over_; }
  bool complete() const { return complete_; }
  /// Why it failed, or empty.
  std::string trouble() const;

 private:
  void run(Store store, int jobs);
  void look(const Store& store);

  const Registry& registry_;
  const Plan plan_;
  std::atomic<bool> interrupted_{false}, over_{false}, complete_{false};
  mutable std::mutex mutex_;  // guards what follows
  LabProgress progress_;
  std::shared_ptr<const LabView> view_;
  std::string trouble_;
  std::thread thread_;
};

}  // namespace surefoot
