// SPDX-License-Identifier: GPL-3.0-or-later
// The name of the session beside the page tabs: the name of its file, with a * while learned values are not saved.
#pragma once

#include "ui/style/painted.h"

namespace surefoot {

class SessionName final : public Painted<> {
  Q_OBJECT

 public:
  explicit SessionName(QWidget* parent);
  void say(const QString& name, bool unsaved, const QString& tip);
  /// The text that is shown: "walks*".
  QString text() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  QString name_;
  bool unsaved_ = false;
};

}  // namespace surefoot
