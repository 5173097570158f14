// SPDX-License-Identifier: GPL-3.0-or-later
// The key to the colours in the head of "What the robot would do now": Q⁻, Q⁺ and Q if the agent keeps two parts; the
// policies if an action is a combination (else their names stand above the columns).
#pragma once

#include <vector>

#include "ui/controls/panel.h"
#include "ui/style/painted.h"
#include "ui/style/theme.h"

namespace surefoot {

class Looking;
class RunningLife;

class ActionKey final : public Painted<>, public Folding {
  Q_OBJECT

 public:
  explicit ActionKey(RunningLife& life, Looking& looking, QWidget* parent = nullptr);
  QSize sizeHint() const override;
  void fold(int room) override;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  static constexpr double kUsualGap = 14, kLeastGap = 6;
  struct Item {
    QString text;
    std::string policy;  // empty: a part of Q
    bool strong = false;
    bool operator==(const Item&) const = default;
  };
  void refresh();
  double widthOf(const Item& item) const;
  int widthWith(double gap) const;
  void drawSample(QPainter& painter, QPointF at, const Item& item, const Theme& theme) const;

  RunningLife& life_;
  Looking& looking_;
  std::vector<Item> items_;
  double gap_ = kUsualGap;  // between two items [px]
};

}  // namespace surefoot
