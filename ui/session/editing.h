// SPDX-License-Identifier: GPL-3.0-or-later
// A person's changes of the life that runs: parameters, policy, scenario. Undo takes changes of parameters back.
#pragma once

#include <QObject>
#include <string>

#include "ui/running/running_life.h"
#include "ui/session/history.h"

namespace surefoot {

class Editing final : public QObject {
  Q_OBJECT

 public:
  Editing(RunningLife& life, History& history) : life_(life), history_(history) {}

  /// Changes a parameter of the running life, or, if it needs a new table, asks for a restart first (needsNewTable).
  Status setParameter(const std::string& key, double value);
  void setPolicy(const std::string& name);
  /// From now on the Q-function in this file is the guardian.
  Status guardBy(const std::string& path);
  void setScenario(const std::string& name);

 Q_SIGNALS:
  void needsNewTable(const QString& key, double value);

 private:
  RunningLife& life_;
  History& history_;
};

}  // namespace surefoot
