// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box with a name that the wheel leaves alone.
#pragma once

#include <QComboBox>

namespace surefoot {

class Combo final : public QComboBox {
  Q_OBJECT

 public:
  explicit Combo(const QString& name, QWidget* parent = nullptr);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

}  // namespace surefoot
