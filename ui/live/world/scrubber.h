// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of a playback, in the head of the world: play or stop, the moment, back to live. They take no room while
// the world is live.
#pragma once

#include <QWidget>

#include "ui/controls/panel.h"

namespace surefoot {

class LinkButton;
class Looking;
class Slider;

class Scrubber final : public QWidget, public Folding {
  Q_OBJECT

 public:
  explicit Scrubber(Looking& looking, QWidget* parent = nullptr);
  void fold(int room) override;

 Q_SIGNALS:
  void goOnAsked();

 private:
  void refresh();
  void place();

  Looking& looking_;
  LinkButton *play_, *goOn_, *live_;
  Slider* slider_;
};

}  // namespace surefoot
