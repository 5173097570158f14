// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of an experiment as text, checked while it is typed.
#pragma once

#include <QWidget>
#include <functional>

#include "core/plans/plan.h"
#include "ui/support/background.h"

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace surefoot {

class ConditionForm;
class Experiment;

class PlanEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit PlanEditor(Experiment& experiment, QWidget* parent = nullptr);
  QString text() const;
  /// Replaces the text, as one step that can be undone.
  void setText(const QString& text);
  /// The text differs from the experiment's plan.
  bool hasEdits() const;
  /// Writes a [[condition]] block behind the others, as one step that can be undone; refused, with the reason below the
  /// text, where the plan would not run with it.
  void addCondition(const std::string& toml);
  /// The same with a block made from a configuration, under a free name.
  void addConfiguration(const Configuration& configuration);

 Q_SIGNALS:
  /// Asks for a condition with the configuration of the Live page.
  void liveConditionAsked();
  /// The text is the experiment's plan now.
  void used();

 private:
  using MakeBlock = std::function<Result<std::string>(const Result<Plan>& now)>;
  void add(MakeBlock block);
  void check();
  void use();
  void say(const QString& sentence);
  std::string path() const;

  Experiment& experiment_;
  QString used_;  // the text that is the experiment's plan
  QPlainTextEdit* edit_;
  ConditionForm* form_;
  QLabel* verdict_;
  QPushButton* use_;
  Background checking_;  // last member: its destructor runs first and waits
};

}  // namespace surefoot
