// SPDX-License-Identifier: GPL-3.0-or-later
// The knobs of a step: the parameters that it shows, and the choices of policy, learning rule and scenario.
#pragma once

#include <QTimer>
#include <QWidget>
#include <map>
#include <vector>

class QVBoxLayout;

namespace surefoot {

class Combo;
class ParameterRow;
class Session;

class KnobRows final : public QWidget {
  Q_OBJECT

 public:
  /// `shown`: what the step shows; what is no knob is passed over.
  using Ranges = std::map<std::string, std::pair<double, double>>;  // of sliders, where a lesson has its own
  KnobRows(Session& session, const std::vector<std::string>& shown, const Ranges& ranges, QWidget* parent = nullptr);
  bool empty() const { return count_ == 0; }
  int count() const { return count_; }
  /// The step is the student's from now on: Reset goes back to the values of this moment. Once.
  void takeBase();

 Q_SIGNALS:
  void refused(const QString& sentence);

 private:
  void addParameter(const std::string& key);
  void addChoice(const std::string& what);
  void edit(const QString& key, double value);
  void refresh();

  Session& session_;
  QTimer anew_;
  const Ranges ranges_;
  const bool runs_;  // the step lets one run the life
  QVBoxLayout* column_;
  std::vector<ParameterRow*> rows_;
  std::map<std::string, Combo*> choices_;
  std::map<std::string, double> began_;  // the values when the step began: those of Reset
  int count_ = 0;
  bool hasBase_ = false;
};

}  // namespace surefoot
