// SPDX-License-Identifier: GPL-3.0-or-later
// The way back for the keyboard: the window's shortcuts are single keys, which a field, a slider or a button that has
// the focus would keep. Escape gives the focus back to where they work; so does Return in a number of the Live page.
#pragma once

#include <QObject>
#include <functional>

class QWidget;

namespace surefoot {

/// Watches the whole program, but acts only in its own window, never in dialogs.
class FocusHome final : public QObject {
  Q_OBJECT

 public:
  /// `home` puts the focus where the shortcuts work. Escape first does what `cancel` does, if that is anything.
  /// `returns` says where Return gives the focus back as well.
  FocusHome(QWidget* window, std::function<void()> home, std::function<bool()> cancel,
            std::function<bool(const QWidget&)> returns);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* window_;
  std::function<void()> home_;
  std::function<bool()> cancel_;
  std::function<bool(const QWidget&)> returns_;
};

}  // namespace surefoot
