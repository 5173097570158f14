// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of an experiment as text, checked while it is typed.
#pragma once

#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace surefoot {

class Experiment;
struct Configuration;

class PlanEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit PlanEditor(Experiment& experiment, QWidget* parent = nullptr);
  QString text() const;
  void setText(const QString& text);
  /// Writes a condition that is this configuration behind the others.
  void addCondition(const std::string& toml);

 Q_SIGNALS:
  /// What the Live page runs shall become a condition.
  void liveConditionAsked();
  /// The text is the experiment's plan now.
  void used();

 private:
  void check();
  void use();

  Experiment& experiment_;
  QPlainTextEdit* edit_;
  QLabel* verdict_;
  QPushButton* use_;
};

/// A [[condition]] block that runs what a configuration says, named after its policy.
std::string conditionToml(const Configuration& configuration, const Configuration& defaults);

}  // namespace surefoot
