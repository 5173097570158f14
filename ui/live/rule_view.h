// SPDX-License-Identifier: GPL-3.0-or-later
// The rule of thumb for TRL's threshold (thesis, section 4.3): its number, the formula that gives this number, its
// limits, and a button that sets the threshold to it.
#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/style/painted.h"

class QPushButton;

namespace surefoot {

class Editing;
class RunningLife;
struct RuleOfThumb;

class RuleView final : public Painted<> {
  Q_OBJECT

 public:
  explicit RuleView(RunningLife& life, Editing& editing, QWidget* parent = nullptr);
  QSize sizeHint() const override { return scaled({300, 200}); }
  QSize minimumSizeHint() const override { return scaled({240, 150}); }
  /// Its text: the number first; one sentence if there is no rule.
  QStringList lines() const;

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  const RuleOfThumb* rule() const;
  QString inForce() const;
  void refresh();
  /// Whether the button stands below the number, as there is no room beside it.
  bool stacked() const;
  void use();

  RunningLife& life_;
  Editing& editing_;
  QPushButton* use_;
};

}  // namespace surefoot
