// SPDX-License-Identifier: GPL-3.0-or-later
// "Pre-learn, then transfer": two columns of the model, simulation and reality, a pool of Q-functions learned on the
// first, and the life on the second that begins with one of them.
#pragma once

#include <QDialog>
#include <vector>

#include "core/parameters.h"
#include "ui/q_pool.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace surefoot {

class Combo;
class Session;

class PreLearningDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PreLearningDialog(Session& session, QWidget* parent);

 Q_SIGNALS:
  /// A life has begun with a Q-function of the pool.
  void transferred(const QString& sentence);

 private:
  struct Row {
    Parameter parameter;
    QLineEdit *simulation, *reality;
  };
  void makeModel(QGridLayout* grid);
  void makeLearning(QGridLayout* grid);
  void makePool(QGridLayout* grid);
  void useScenario(const std::string& name);
  Result<Configuration> model(QLineEdit* Row::*column) const;
  void startOrStop();
  void transfer();
  void refresh();
  void refreshRow(int row);

  Session& session_;
  QPool pool_;
  std::vector<Row> rows_;
  Combo* scenario_ = nullptr;
  QLineEdit* until_ = nullptr;
  QSpinBox* size_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton *start_ = nullptr, *transfer_ = nullptr;
  QLabel* words_ = nullptr;
};

}  // namespace surefoot
