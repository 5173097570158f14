// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the time axis that the charts of a life show, all of them the same; and the place on it that is read.
#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "core/life/learning_curve.h"

namespace surefoot {

class RunningLife;
struct Task;

/// Where a state of the life stands on the time axis: simulated minutes, or episodes where the task has no clock.
double timeOf(const Task& task, std::int64_t episode, std::int64_t lifeSteps);
inline double timeOf(const Task& task, const CurvePoint& point) {
  return timeOf(task, point.episode, point.lifeSteps);
}

class ChartSpan final : public QObject {
  Q_OBJECT

 public:
  explicit ChartSpan(RunningLife& life, QObject* parent = nullptr);

  /// All of the life; as far as it learned; or a part that was chosen. Until one of them is asked for, it is the whole
  /// life, and, when learning has ended and would be pressed against the axis, as far as it learned.
  enum class Shows { WholeLife, Learning, Part };
  Shows shows() const;
  double from() const { return from_; }  ///< [min] or episodes
  double to() const { return to_; }
  /// A second learner's life counts as well (nullptr: there is none).
  void setSecond(RunningLife* second);

  void showWholeLife();
  void showLearning();
  void showPart(double from, double to);
  /// `factor` < 1: closer. What stands at `anchor` stays there.
  void zoom(double factor, double anchor);
  /// By a share of what is shown; never beyond the ends.
  void pan(double share);

  /// The place under the cursor; none: nobody reads.
  std::optional<double> cursor() const { return cursor_; }
  void setCursor(std::optional<double> at);

 Q_SIGNALS:
  void changed();
  void cursorChanged();

 private:
  void refresh();
  void wish(std::optional<Shows> shows);
  double endOfLearning() const;  ///< 0: not yet
  double whole() const;

  RunningLife& life_;
  QPointer<RunningLife> second_;
  std::optional<Shows> wished_;
  double from_ = 0, to_ = 1;
  std::optional<double> cursor_;
};

}  // namespace surefoot
