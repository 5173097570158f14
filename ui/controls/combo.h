// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box with a name that the wheel leaves alone.
#pragma once

#include <QComboBox>
#include <string>

namespace surefoot {

class Combo final : public QComboBox {
  Q_OBJECT

 public:
  explicit Combo(const QString& name, QWidget* parent = nullptr);
  /// The name behind the item that is chosen, "" where there is none: items carry names as their data.
  std::string chosen() const;
  /// The item of this name; where there is none the choice stays as it is.
  void choose(const std::string& name);
  /// The data of its items are names of policies: each has its marker, in the theme's and the text's size.
  void setPolicyMarkers();

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  bool markers_ = false;
};

}  // namespace surefoot
