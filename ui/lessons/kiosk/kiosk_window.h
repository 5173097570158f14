// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson for a booth: the same robot twice on the whole screen, one knob, and nothing that leads away. Both explore
// equally often, one anything, the other what is nearly as good. Without a touch it begins again by itself.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "core/lessons/equal_share.h"
#include "core/lessons/lesson.h"
#include "ui/lessons/kiosk/kiosk_foot.h"
#include "ui/support/background.h"

class QLabel;

namespace surefoot {

class KioskRobot;

class KioskWindow final : public QWidget {
  Q_OBJECT

 public:
  /// `start`: the configuration that both lives begin with; `resetAfter` [s].
  KioskWindow(const Registry& registry, const Lesson& lesson, const Configuration& start, int resetAfter,
              QWidget* parent = nullptr);
  ~KioskWindow() override;

  KioskRobot& robot(int which) { return which == 0 ? *first_ : *second_; }
  ShareSlider& slider() { return foot_->slider(); }
  /// The knob goes back, and both begin anew.
  void beginAgain();
  /// Seconds until it begins again by itself; nothing: somebody is there.
  std::optional<int> secondsLeft() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeHead();
  void measureShares();
  void beginBoth();
  void push();
  void touched();
  void tick();
  void refresh();
  void tellFalls();

  const Registry& registry_;
  const LessonKiosk kiosk_;
  const Configuration start_;
  const int resetAfter_;
  KioskRobot *first_, *second_;
  KioskFoot* foot_;
  QLabel* countdown_ = nullptr;
  QWidget* again_ = nullptr;
  QTimer ticking_, settling_;
  QElapsedTimer untouched_, announced_;
  std::vector<ShareOfTemperature> shares_;
  double epsilon_ = 0, temperature_ = 0;
  bool holding_ = false, wasTouched_ = false;
  Background measuring_;
};

/// The configuration that a lesson's kiosk begins with: that of its first step.
Result<Configuration> kioskStart(const Registry& registry, const Lesson& lesson);

}  // namespace surefoot
