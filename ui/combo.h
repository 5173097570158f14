// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box in ink: hairline frame, a chevron, no wheel.
#pragma once

#include <QComboBox>

namespace surefoot {

class Combo final : public QComboBox {
  Q_OBJECT

 public:
  explicit Combo(const QString& name, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace surefoot
