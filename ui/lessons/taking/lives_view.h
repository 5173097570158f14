// SPDX-License-Identifier: GPL-3.0-or-later
// Several lives of each of a few ways: a dot for each life, the mean and its 95 % interval.
#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/statistics/statistics.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

namespace surefoot {

class LivesView final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  /// `paired`: the lives of one number have the same seed in every way.
  LivesView(QStringList labels, QString unit, bool paired, QWidget* parent = nullptr);
  /// What each life of each way came to; empty: they are still being lived.
  void show(std::vector<std::vector<double>> lives);
  /// A row for the difference of two ways, once the question about it is answered.
  void showDifference(bool on);
  std::string asCsv() const override;
  QSize sizeHint() const override { return scaled({440, 240}); }
  QSize minimumSizeHint() const override { return scaled({280, 140}); }

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void chooseScale();
  double xOf(double value) const;
  double lineOf(std::size_t way) const;  ///< the height of a way's line
  void paintPairs(QPainter& p) const;
  void paintTexts(QPainter& p, std::size_t way) const;
  void paintDots(QPainter& p, std::size_t way) const;
  void paintMean(QPainter& p, std::size_t way) const;
  void paintDifference(QPainter& p) const;
  void paintInterval(QPainter& p, const Interval& interval, double y) const;
  void paintAxis(QPainter& p, double bottom) const;
  std::optional<Interval> difference() const;

  const QStringList labels_;
  const QString unit_;
  const bool paired_;
  bool isDifferenceShown_ = false;
  std::vector<std::vector<double>> lives_;
  double low_ = 0, high_ = 1, step_ = 0.2, left_ = 0, right_ = 1, top_ = 0, row_ = 1;
};

}  // namespace surefoot
