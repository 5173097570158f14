// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the time axis that all charts of a life show, and the time that the cursor reads.
#pragma once

#include <QObject>
#include <QPointer>
#include <optional>

#include "core/life/learning_curve.h"

namespace surefoot {

class RunningLife;
struct RunCurve;

class ChartSpan final : public QObject {
  Q_OBJECT

 public:
  explicit ChartSpan(RunningLife& life, QObject* parent = nullptr);

  /// The whole life; the time of learning; or a chosen part. Without a choice it is the whole life, or the time of
  /// learning if learning has ended and would be pressed against the axis.
  enum class Shows { WholeLife, Learning, Part };
  Shows shows() const;
  double from() const { return from_; }  ///< [min] or episodes
  double to() const { return to_; }
  /// The time axis counts simulated minutes, or episodes: if the task has no clock, or if it was asked for.
  bool inMinutes() const;
  void countEpisodes(bool episodes);
  /// The position of a moment of a life on the time axis.
  double timeOf(std::int64_t episode, std::int64_t lifeSteps) const;
  double timeOf(const CurvePoint& point) const { return timeOf(point.episode, point.lifeSteps); }
  /// The whole life is shown up to this time at least; 0: up to the end of the curves.
  void setLeast(double least);
  /// A second learner's life counts as well (nullptr: there is none).
  void setSecond(RunningLife* second);

  void showWholeLife();
  void showLearning();
  void showPart(double from, double to);
  /// `factor` < 1: closer. The time at `anchor` stays in its place.
  void zoom(double factor, double anchor);
  /// Moves by a share of the shown part; never beyond the ends.
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
  double endOf(const RunCurve& curve) const;
  double whole() const;

  RunningLife& life_;
  QPointer<RunningLife> second_;
  std::optional<Shows> wished_;
  std::uint64_t lineage_ = 0;  // of the life that is shown
  bool episodes_ = false;
  double least_ = 0;
  double from_ = 0, to_ = 1;
  std::optional<double> cursor_;
};

}  // namespace surefoot
