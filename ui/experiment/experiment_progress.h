// SPDX-License-Identifier: GPL-3.0-or-later
// How far an experiment is: "228 of 240 lives", a bar, time elapsed and left.
#pragma once

#include "ui/style/painted.h"

namespace surefoot {

class Experiment;

class ExperimentProgress final : public Painted<> {
  Q_OBJECT

 public:
  explicit ExperimentProgress(Experiment& experiment, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  Experiment& experiment_;
};

}  // namespace surefoot
