// SPDX-License-Identifier: GPL-3.0-or-later
// Tries a copy of what the life has learned, on threads of its own; the learner goes on. The Q-function, the checks and
// the trials are those of `surefoot robustness`, so the numbers are, too.
#pragma once

#include <QObject>
#include <atomic>
#include <memory>
#include <optional>

#include "core/robustness/robustness.h"
#include "ui/support/background.h"

namespace surefoot {

class LifeFiles;
class RunningLife;

class RobustnessRun final : public QObject {
  Q_OBJECT

 public:
  /// A map of more is no map; the command takes more.
  static constexpr std::size_t kMostRows = 200, kMostColumns = 50;
  RobustnessRun(RunningLife& life, LifeFiles& files, QObject* parent = nullptr);

  /// `second`: the file of another Q-function, or nothing.
  void start(const RobustnessQuestion& question, const std::string& second);
  void cancel();
  bool busy() const { return copying_ || background_.busy(); }
  double share() const { return share_; }
  /// What came out last; null: nothing yet.
  const std::shared_ptr<const Robustness>& result() const { return result_; }
  /// The Q-function of the life that it is of; null: nothing yet.
  const std::shared_ptr<const TensorFile>& tried() const { return tried_; }

 Q_SIGNALS:
  void changed();  ///< it began, went on, or ended
  void finished();
  void refused(const QString& sentence);

 private:
  void tryWith(const RobustnessQuestion& question, const std::string& second,
               const std::shared_ptr<const TensorFile>& function);

  RunningLife& life_;
  LifeFiles& files_;
  std::shared_ptr<const Robustness> result_;
  std::shared_ptr<const TensorFile> tried_;
  bool copying_ = false;
  std::uint64_t number_ = 0;  // of the last start; copies for earlier ones are not wanted any more
  std::atomic<double> share_{0.0};
  CallQueue calls_;  // of the background's thread: destroyed after it
  Background background_;
};

}  // namespace surefoot
