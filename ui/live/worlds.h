// SPDX-License-Identifier: GPL-3.0-or-later
// One world, or two: side by side or one above the other, whichever shows them larger.
#pragma once

#include <QSplitter>

namespace surefoot {

class Worlds final : public QSplitter {
 public:
  explicit Worlds(QWidget* parent = nullptr);
  /// Of worlds side by side: there is always a way to that.
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace surefoot
