// SPDX-License-Identifier: GPL-3.0-or-later
// "ε 0.25", "ε 0.05 → 0.25", "Softmax, τ 1": what a lesson's curves are called, by what the lesson changes.
#pragma once

#include <QCoreApplication>
#include <QStringList>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace surefoot {

class LessonDriver;
struct RunCurve;

class CurveNames {
  Q_DECLARE_TR_FUNCTIONS(surefoot::CurveNames)

 public:
  explicit CurveNames(LessonDriver& driver);
  QString of(const RunCurve& curve) const;
  /// Names the life in hand as it is lived now. A curve is named when its life begins; a knob that is turned while it
  /// runs is told.
  void note();

 private:
  QStringList words() const;

  struct Name {
    QStringList words;
    std::size_t step;  ///< in which it was named
  };
  LessonDriver& driver_;
  std::vector<std::string> changed_;       // keys that the lesson's actions set
  bool policies_ = false, rules_ = false;  // the lesson has several of them
  std::map<int, Name> names_;              // by the numbers of lives
};

}  // namespace surefoot
