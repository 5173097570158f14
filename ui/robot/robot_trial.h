// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that is tried: it moves in real time under random actions, its hand-made controller, or the keys; or a fall
// of the random life is shown again.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "core/environment_library.h"

namespace surefoot {

class RobotTrial final : public QObject {
  Q_OBJECT

 public:
  /// Passive: without motors, dampers, friction and contacts. Dropped: motors off, from a little above the ground.
  enum class Mode { Random, Still, Passive, Dropped, HandMade, Keys };

  explicit RobotTrial(QObject* parent = nullptr);

  void start(const EnvironmentFile& file, Mode mode);
  /// The random life from the beginning of an episode to a fall, with steps as the inspection counts them.
  void replay(const EnvironmentFile& file, int begin, int fall);
  void stop();
  bool isRunning() const { return environment_ != nullptr; }
  Mode mode() const { return mode_; }
  void setMode(Mode mode);
  bool handMade() const { return environment_ && environment_->task().handMade; }
  /// 1 … 9: a level of the action; what it means is in words(); the arrows push. False: the key means nothing.
  bool press(int key);
  QString words() const;

 Q_SIGNALS:
  void moved(const Scene& scene);
  void stopped();

 private:
  void advance();
  Action chosen();
  void show();

  std::unique_ptr<Environment> environment_;
  Random random_{1};
  Mode mode_ = Mode::Random;
  Action action_ = 0;
  double due_ = 0;  // steps to make
  int until_ = -1;  // of a replay: the steps that are left; −1: it is none
  int falls_ = 0, episodes_ = 0;
  int rest_ = 0;  // frames that an episode's end is looked at
  QTimer timer_;
};

}  // namespace surefoot
