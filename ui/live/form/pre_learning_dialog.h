// SPDX-License-Identifier: GPL-3.0-or-later
// "Pre-learn, then transfer": the differences between simulation and reality, a pool of Q-functions learned in the
// simulation, and a life in reality that begins with one of them. It fits every screen: long contents scroll.
#pragma once

#include <QDialog>
#include <string>

#include "ui/session/q_pool.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTableWidget;
class QVBoxLayout;

namespace surefoot {

class Combo;
class ModelRows;
class NewLives;
class RunningLife;

class PreLearningDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit PreLearningDialog(RunningLife& life, NewLives& newLives, QWidget* parent);

 Q_SIGNALS:
  /// A life has begun with a Q-function of the pool.
  void transferred(const QString& sentence);

 private:
  void makeModel(QGridLayout* grid);
  void makeLearning(QGridLayout* grid);
  void makePool(QGridLayout* grid);
  void makeFoot(QVBoxLayout* column);
  void fitToScreen();
  void useScenario(const std::string& name);
  void startOrStop();
  void transfer();
  void refresh();
  void refreshRow(int row);

  RunningLife& life_;
  NewLives& newLives_;
  QPool pool_;
  ModelRows* model_;
  Combo* scenario_ = nullptr;
  QLineEdit* until_ = nullptr;
  QSpinBox* size_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton *start_ = nullptr, *transfer_ = nullptr;
  QLabel* words_ = nullptr;
};

}  // namespace surefoot
