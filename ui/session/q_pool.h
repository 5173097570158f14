// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions learned on a model that differs from the robot, one after the other on a thread of its own: the pool that
// a life in the real world can begin with (thesis, section 4.2.1).
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/experiment/configuration.h"
#include "ui/session/background.h"

namespace surefoot {

struct PreLearned {
  std::shared_ptr<const TensorFile> file;
  std::int64_t episodes = 0, falls = 0;
  double averageReward = 0;  ///< of the last 80 episodes
  bool reached = false;      ///< what was asked for
};

class QPool final : public QObject {
  Q_OBJECT

 public:
  static constexpr std::int64_t kCap = 20'000;  ///< episodes; the cap is ours
  explicit QPool(const Registry& registry, QObject* parent = nullptr);

  /// `simulation` is what is learned on, with its seed and how long: until an average reward (and kCap episodes at the
  /// most), or so many minutes or episodes. Policy and start are set here: ε-greedy, from nothing. Life i of the pool
  /// is life i of that configuration.
  void start(Configuration simulation, int pool);
  void cancel() { background_.cancel(); }
  bool busy() const { return background_.busy(); }
  int asked() const { return asked_; }
  /// Those that are ready.
  const std::vector<PreLearned>& pool() const { return pool_; }

 Q_SIGNALS:
  void changed();  ///< one more is ready, or it began, or ended
  void refused(const QString& sentence);

 private:
  void take(PreLearned one, std::uint64_t run);

  const Registry& registry_;
  std::vector<PreLearned> pool_;
  int asked_ = 0;
  std::uint64_t run_ = 0;  // those of an earlier one come too late
  Background background_;
};

}  // namespace surefoot
