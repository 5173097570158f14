// SPDX-License-Identifier: GPL-3.0-or-later
// A form that writes a [[condition]] block of a plan: environment, learning rule, policy, and the varied parameters.
#pragma once

#include <QWidget>
#include <array>

#include "core/plans/plan.h"

class QFormLayout;
class QLabel;
class QLineEdit;

namespace surefoot {

class Combo;

class ConditionForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ConditionForm(const Registry& registry, QWidget* parent = nullptr);
  /// The block as the form is filled in; an error names the field.
  Result<std::string> toml() const;
  /// Fills the form in like this condition, unless a person has filled something in.
  void beginAs(const Condition& condition);
  /// A person's entries may be overwritten now.
  void forget() { touched_ = false; }

 private:
  struct Sweep {
    Combo* key;
    QLineEdit* values;
  };
  void makePreLearning(QFormLayout* form);
  void watch();
  void fillForEnvironment();
  void fillKeys();
  void setCounted(bool episodes);
  bool hasClock() const;
  Result<std::string> length() const;
  Result<std::string> preLearning() const;
  Names names() const;
  std::string name() const;

  const Registry& registry_;
  bool touched_ = false;
  bool episodes_ = false;  // a life's length is counted in episodes, not in minutes
  QLabel* lengthLabel_;
  QLineEdit *name_, *length_, *until_, *pool_;
  Combo *environment_, *scenario_, *agent_, *features_, *policy_, *preLearned_;
  std::array<Sweep, 2> sweeps_;
};

}  // namespace surefoot
