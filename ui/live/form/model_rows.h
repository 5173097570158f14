// SPDX-License-Identifier: GPL-3.0-or-later
// The differences between simulation and reality: one row per parameter, with its value in each. Parameters with equal
// values are not shown; a person finds one by name and adds it.
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "ui/running/running_life.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace surefoot {

class ModelRows final : public QWidget {
  Q_OBJECT

 public:
  enum class Side { Simulation, Reality };
  explicit ModelRows(const RunningLife& life, QWidget* parent = nullptr);
  /// Whether this environment's model has anything to be wrong about.
  bool empty() const { return rows_.empty(); }
  /// A scenario's values as the simulation's; the rest is as in reality.
  void simulate(const std::vector<std::pair<std::string, double>>& values);
  /// The session's configuration with the values of one side; the error names the value that cannot be.
  Result<Configuration> model(Side side) const;

 Q_SIGNALS:
  /// A value of the simulation was typed: the values are no scenario any more.
  void simulationTyped();

 private:
  struct Row {
    Parameter parameter;
    double simulation, reality;  ///< exact; the shown values are rounded
    QLabel* name = nullptr;      ///< made when the row is first shown
    QLineEdit *first = nullptr, *second = nullptr;
  };
  QLineEdit* makeField(const Row& row, double value, const QString& where);
  void show(Row& row);
  void addChosen();
  void fillChoices();

  const RunningLife& life_;
  QGridLayout* grid_;
  QLabel* alike_;
  std::array<QLabel*, 2> heads_{};  // of the columns with values
  QComboBox* add_;
  std::vector<Row> rows_;
};

}  // namespace surefoot
