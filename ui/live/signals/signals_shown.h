// SPDX-License-Identifier: GPL-3.0-or-later
// What strip charts, phase portrait and strides show together: which signals, which part of the time, which stride.
#pragma once

#include <QColor>
#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/signals/strides.h"
#include "ui/live/signals/strips.h"

class QWidget;

namespace surefoot {

class Looking;
class RunningLife;
struct Theme;

/// Another life in the same environment, whose signals stand beside those of the first.
struct LifeBeside {
  QPointer<RunningLife> life;
  QPointer<Looking> looking;
  /// To be added to its times; none: that is not known (yet).
  std::function<std::optional<double>()> later;
};

/// A stride of the first, or of the second.
struct MarkedStride {
  std::size_t stride = 0;
  bool ofSecond = false;
  bool operator==(const MarkedStride&) const = default;
};

class SignalsShown final : public QObject {
  Q_OBJECT

 public:
  static constexpr double kLive = 30.0;  ///< shown of a world that goes on [s]

  SignalsShown(RunningLife& life, Looking& looking, QObject* parent);
  /// While this view is visible, signals are written down.
  void watchedBy(QWidget& view);

  const SignalTable& table() const;
  /// What another Q-function does in the same roll-out or replay, or what a life beside the first does; no rows: none.
  const SignalTable& second() const;
  /// To be added to the second's times.
  double secondLater() const;
  /// What the two are called.
  std::pair<QString, QString> names() const;
  void setBeside(LifeBeside beside);
  /// The row of the moment that is shown.
  std::optional<std::size_t> row() const;
  void seek(double time);
  bool hasClock() const;
  QColor learnerColour(const Theme& theme) const;

  const std::vector<Strip>& strips() const { return strips_; }
  void setStrips(std::vector<Strip> strips);
  void setUsualStrips();

  double from() const;
  double to() const;
  /// Nothing was magnified.
  bool showsAll() const { return !part_; }
  void showAll();
  /// Shows a shorter or longer time around this one.
  void magnify(double factor, double around);
  void shift(double share);

  /// The axes of the phase portrait, as places in the table.
  std::pair<std::size_t, std::size_t> axes() const;
  void setAxes(const std::string& x, const std::string& y);

  const std::vector<Stride>& strides() const { return strides_; }
  const std::vector<Stride>& secondStrides() const { return secondStrides_; }
  std::optional<MarkedStride> markedStride() const { return marked_; }
  void markStride(std::optional<MarkedStride> stride);
  std::optional<std::pair<double, double>> band() const;
  /// Rows of the marked stride or of the last one; where nobody walks, of the last time in which x went up through its
  /// mean to the next time it does.
  std::optional<std::pair<std::size_t, std::size_t>> cycle(const SignalTable& table,
                                                           const std::vector<Stride>& strides) const;

 Q_SIGNALS:
  void changed();  ///< what is shown is other than before
  void moment();   ///< the moment is another, or a row was added: some 20 times a second
  void stridesChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void followEnvironment();
  void nextFrame();
  void findStrides();
  double end() const;
  void watchSignals(const QObject* view, bool watches);
  /// The life beside is what is shown as the second.
  bool showsBeside() const;
  const Stride* marked() const;

  RunningLife& life_;
  Looking& looking_;
  LifeBeside beside_;
  std::set<const QObject*> visible_;
  std::string environment_;
  std::vector<Strip> strips_;
  std::string x_, y_;
  std::optional<std::pair<double, double>> part_;
  std::vector<Stride> strides_, secondStrides_;
  std::optional<MarkedStride> marked_;
  QElapsedTimer sinceStrides_, sinceMoment_;
};

}  // namespace surefoot
