// SPDX-License-Identifier: GPL-3.0-or-later
// One of the two robots of a kiosk: its way to explore, its falls and its world.
#pragma once

#include <QWidget>

#include "ui/session/session.h"

class QLabel;

namespace surefoot {

class WorldView;

class KioskRobot final : public QWidget {
  Q_OBJECT

 public:
  KioskRobot(const Registry& registry, Configuration configuration, const QString& name, const QString& about,
             QWidget* parent = nullptr);
  ~KioskRobot() override;
  Session& session() { return *session_; }
  WorldView& world() { return *world_; }
  /// Shows where one can touch.
  void invite(bool on);
  /// Begins anew with a value for its knob.
  Status begin(const std::string& key, double value);

 private:
  void refresh();

  std::unique_ptr<Session> session_;
  Configuration start_;
  WorldView* world_;
  QLabel* falls_;
  QWidget* invitation_;
};

}  // namespace surefoot
