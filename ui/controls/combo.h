// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box with a name; the mouse wheel does not change it.
#pragma once

#include <QComboBox>
#include <string>

namespace surefoot {

class Combo final : public QComboBox {
  Q_OBJECT

 public:
  explicit Combo(const QString& name, QWidget* parent = nullptr);
  /// The name of the chosen item, or "" without one: names are the data of the items.
  std::string chosen() const;
  /// Chooses the item with this name; if there is none, the choice does not change.
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
