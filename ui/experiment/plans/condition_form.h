// SPDX-License-Identifier: GPL-3.0-or-later
// A form that writes a [[condition]] block of a plan: what is learned where, by which rule, what is varied.
#pragma once

#include <QWidget>
#include <array>

#include "core/experiment/configuration.h"

class QFormLayout;
class QLineEdit;

namespace surefoot {

class Combo;

class ConditionForm final : public QWidget {
  Q_OBJECT

 public:
  explicit ConditionForm(const Registry& registry, QWidget* parent = nullptr);
  /// The block as the form is filled in; an error names the field.
  Result<std::string> toml() const;

 Q_SIGNALS:
  void addAsked();

 private:
  struct Sweep {
    Combo* key;
    QLineEdit* values;
  };
  void makePreLearning(QFormLayout* form);
  void fillForEnvironment();
  void fillKeys();
  Names names() const;
  std::string name() const;

  const Registry& registry_;
  QLineEdit *name_, *minutes_, *until_, *pool_;
  Combo *environment_, *scenario_, *agent_, *features_, *policy_, *preLearned_;
  std::array<Sweep, 2> sweeps_;
};

}  // namespace surefoot
