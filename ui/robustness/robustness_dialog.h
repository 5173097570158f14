// SPDX-License-Identifier: GPL-3.0-or-later
// How robust is what the life has learned? What is asked (RobustnessForm), what came out (RobustnessMap), and the
// command that gives the same numbers without a window. The life goes on meanwhile.
#pragma once

#include <QDialog>

#include "ui/robustness/robustness_run.h"

class QLabel;
class QPushButton;

namespace surefoot {

class RobustnessForm;
class RobustnessMap;

class RobustnessDialog final : public QDialog {
  Q_OBJECT

 public:
  RobustnessDialog(RunningLife& life, LifeFiles& files, QWidget* parent);
  /// The environment whose lives it can try.
  const std::string& environment() const { return environment_; }
  /// The file of a Q-function that is to be tried beside.
  void setSecond(const QString& path);

 Q_SIGNALS:
  void secondChosen(const QString& path);  ///< by a person

 private:
  QWidget* makeBody();
  QWidget* makeFoot();
  void tryOrStop();
  void saveTried();
  void exportMap();
  void say(const QString& sentence);
  void refresh();
  void refreshWords();
  void refreshCommand();

  RunningLife& life_;
  const std::string environment_;
  RobustnessRun run_;
  RobustnessForm* form_;
  RobustnessMap* map_;
  QLabel *words_ = nullptr, *command_ = nullptr;
  QPushButton *try_ = nullptr, *save_ = nullptr, *export_ = nullptr, *copy_ = nullptr;
  std::string saved_{};  // the file of what was tried; empty: it is not saved
  QString said_{};       // a sentence in place of the usual words
};

}  // namespace surefoot
