// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box with a name that the wheel leaves alone.
#pragma once

#include <QComboBox>

namespace surefoot {

class Combo final : public QComboBox {
  Q_OBJECT

 public:
  explicit Combo(const QString& name, QWidget* parent = nullptr);
  /// The data of its items are names of policies: each has its marker, in the theme's and the text's size.
  void setPolicyMarkers();

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  bool markers_ = false;
};

}  // namespace surefoot
