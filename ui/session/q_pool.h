// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions learned on a model that differs from the robot, one after the other on a thread of its own: the pool that
// a life in the real world can begin with (thesis, section 4.2.1).
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/experiment/configuration.h"
#include "ui/support/background.h"

namespace surefoot {

struct PreLearned {
  std::shared_ptr<const TensorFile> file;
  std::int64_t episodes = 0, falls = 0;
  double averageReward = 0;  ///< over the last 80 episodes
  bool reached = false;      ///< the average reward that was asked for
};

class QPool final : public QObject {
  Q_OBJECT

 public:
  static constexpr std::int64_t kCap = 20'000;  ///< episodes; the cap is ours
  explicit QPool(const Registry& registry, QObject* parent = nullptr);

  /// `simulation` is the configuration to learn with. It has the seed and the length: until an average reward (at most
  /// kCap episodes), or a number of minutes or episodes. Policy and start are set here: ε-greedy, from nothing. Life i
  /// of the pool is life i of that configuration.
  void start(Configuration simulation, int pool);
  void cancel() { background_.cancel(); }
  bool busy() const { return background_.busy(); }
  int asked() const { return asked_; }
  /// The Q-functions that are ready.
  const std::vector<PreLearned>& pool() const { return pool_; }

 Q_SIGNALS:
  void changed();  ///< one more is ready, or it began, or ended
  void refused(const QString& sentence);

 private:
  void take(const PreLearned& one, std::uint64_t run);

  const Registry& registry_;
  std::vector<PreLearned> pool_;
  int asked_ = 0;
  std::uint64_t run_ = 0;  // number of the run; results of an earlier run are ignored
  CallQueue calls_;        // of the background's thread: destroyed after it
  Background background_;
};

}  // namespace surefoot
