// SPDX-License-Identifier: GPL-3.0-or-later
// "This step": the learning update of the last step, in words and numbers (Sutton & Barto 2018, section 12.7).
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "core/live/snapshot.h"
#include "ui/style/painted.h"

class QPainter;

namespace surefoot {

class Looking;
class RunningLife;

class StepView final : public Painted<> {
  Q_OBJECT

 public:
  explicit StepView(RunningLife& life, Looking& looking, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({576, 200}); }
  QSize minimumSizeHint() const override { return scaled({380, 150}); }
  /// The same as text, for screen readers.
  QStringList sentences() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void nextFrame();

  RunningLife& life_;
  Looking& looking_;
  Snapshot shown_;
  QElapsedTimer sinceUpdate_;
};

}  // namespace surefoot
