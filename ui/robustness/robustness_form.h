// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked about robustness, as fields: pushes, models, policy, starts, and a second Q-function.
#pragma once

#include <QWidget>

#include "core/robustness/robustness_plan.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace surefoot {

class Combo;
class OneLine;
class RunningLife;

class RobustnessForm final : public QWidget {
  Q_OBJECT

 public:
  explicit RobustnessForm(const RunningLife& life, QWidget* parent = nullptr);
  RobustnessQuestion question() const;
  /// The file of the second Q-function; empty: there is none.
  const std::string& second() const { return second_; }
  void setSecond(const QString& path);

 Q_SIGNALS:
  void edited();
  void secondChosen(const QString& path);  ///< by a person

 private:
  /// Of a label; the field stands behind it.
  struct Place {
    int row = 0, column = 0, span = 1;
  };
  QLineEdit* addField(const QString& label, const QString& name, const QString& text, const QString& tip, Place place);
  void addModels(const RunningLife& life);
  void addPolicy(const RunningLife& life);
  void addSecond();

  QGridLayout* grid_;
  QLineEdit *push_ = nullptr, *pushAt_ = nullptr, *seconds_ = nullptr, *settings_ = nullptr, *starts_ = nullptr,
            *seed_ = nullptr;
  Combo *scenario_ = nullptr, *policy_ = nullptr;
  OneLine* beside_ = nullptr;
  QPushButton* remove_ = nullptr;
  std::string second_;
};

}  // namespace surefoot
