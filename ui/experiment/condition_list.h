// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of an experiment with how many lives each has lived, and below them its design.
#pragma once

#include "ui/experiment/figures/condition_name.h"
#include "ui/style/painted.h"

namespace surefoot {

class Experiment;

class ConditionList final : public Painted<> {
  Q_OBJECT

 public:
  explicit ConditionList(Experiment& experiment, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  /// The settings that all conditions share: name and value.
  std::vector<std::pair<QString, QString>> design() const;
  QString testWords() const;
  void drawGroup(QPainter& p, const QString& title, double y) const;

  Experiment& experiment_;
  NameGroups names_;
};

}  // namespace surefoot
