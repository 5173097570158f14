// SPDX-License-Identifier: GPL-3.0-or-later
// Below the two robots of a kiosk: the one knob, and what one sees.
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace surefoot {

class ShareSlider;

class KioskFoot final : public QWidget {
  Q_OBJECT

 public:
  /// `word`: who types it leaves the kiosk.
  KioskFoot(double share, std::string word, QWidget* parent);
  ShareSlider& slider() { return *slider_; }
  void show(const QString& sees, const QString& facts);
  /// A field for the word.
  void askForWord();

 Q_SIGNALS:
  void moved();
  void left();

 private:
  QVBoxLayout* makeKnob(double share);
  QVBoxLayout* makeSees();

  const std::string leaves_;
  ShareSlider* slider_;
  QLabel *share_, *sees_ = nullptr, *facts_ = nullptr;
  QLineEdit* word_ = nullptr;
};

}  // namespace surefoot
