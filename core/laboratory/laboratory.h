// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan into a store: the lives that the store does not hold yet, on a pool of threads, each written when it is
// over. The store's content is the same for any number of threads and any order, however often it is paused, stopped
// and gone on with.
#pragma once

#include "core/experiment/meter.h"
#include "core/store/store.h"

namespace surefoot {

struct LabProgress {
  Progress work{};         ///< work of this run: missing lives and the pre-learning that they need
  int livesThere = 0;      ///< lives that the store held before
  int livesPlanned = 0;    ///< all lives of this shard
  std::int64_t falls = 0;  ///< falls of all lives, stored and running; without pre-learning
};

struct LabOptions {
  int jobs = 1;
  int shard = 1, shards = 1;  ///< life number k (of all, in order) belongs to shard k mod shards + 1
  /// Everything ends; running lives are kept beside the store, and the next run continues them.
  const std::atomic<bool>* interrupted = nullptr;
  /// While it is set, lives stand still between two steps. After some seconds they are kept beside the store, too.
  const std::atomic<bool>* paused = nullptr;
  double keepEvery = 300.0;                            ///< [s] a long life is kept so often while it goes on
  std::function<void(const LabProgress&)> progress{};  ///< about four times a second, on the calling thread
  std::function<void(const Store&)> look{};            ///< after `progress`; no life is written meanwhile
};

struct LabResult {
  int livesPlanned = 0, livesThere = 0;  ///< all lives of this shard; lives that the store holds now
  int preLearningsAtCap = 0;             ///< Q-functions of this run that did not reach their reward
  int livesKept = 0;                     ///< unfinished lives and pre-learnings, kept beside the store
  Status keeping = Done{};               ///< why an unfinished life could not be kept
  std::vector<std::string> found{};      ///< what a plan whose lives grow found, in sentences (growth.h)
  bool complete() const { return livesThere == livesPlanned; }
};

/// Runs the missing lives. After an error the written lives are kept; an interruption is no error.
Result<LabResult> runPlan(const Registry& registry, const Plan& plan, Store& store, const LabOptions& options);

}  // namespace surefoot
