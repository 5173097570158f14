// SPDX-License-Identifier: GPL-3.0-or-later
// The slider below the world while something that was seen before is shown.
#pragma once

#include <QWidget>

namespace surefoot {

class Session;
class Slider;

class Scrubber final : public QWidget {
  Q_OBJECT

 public:
  explicit Scrubber(Session& session, QWidget* parent = nullptr);

 private:
  void refresh();
  Session& session_;
  Slider* slider_;
};

}  // namespace surefoot
