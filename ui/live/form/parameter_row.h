// SPDX-License-Identifier: GPL-3.0-or-later
// One parameter in the form: marker, name and symbol, slider, number, unit; after a change, Reset, whose tooltip
// says since when, and the default. The height of a row never changes, so nothing below it moves.
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>
#include <string>

#include "core/parameters.h"
#include "ui/style/painted.h"

class QLineEdit;
class QMouseEvent;
class QToolButton;

namespace surefoot {

class Combo;
class Slider;

class ParameterRow final : public Painted<> {
  Q_OBJECT

 public:
  /// The marker of `policy` stands before the name; empty: no marker.
  ParameterRow(const Parameter& parameter, const std::string& policy, QWidget* parent = nullptr);

  const std::string& key() const { return parameter_.key; }
  /// Shows a value, the value of Reset, and, if it was changed, the step of the change.
  void show(double value, double base, std::optional<std::int64_t> changedAt);
  /// The policy in force, if it uses the parameter, else empty: then the marker is its own policy's, and open.
  void setInForce(const std::string& policy);
  /// Shows for a while, in place of the name, why a value was refused: a few words, and the whole sentence in the
  /// tooltip and for screen readers.
  void tellRefused(const QString& words, const QString& sentence);
  /// The words about a refused value that are shown now; empty: none.
  const QString& refusal() const { return refusal_; }

 Q_SIGNALS:
  void edited(const QString& key, double value);
  /// The text that was typed is no allowed value: one sentence.
  void refused(const QString& sentence);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeNumber(const QString& name);
  void makeReset(const QString& name);
  void layOut();
  double valueAt(int slider) const;
  int sliderAt(double value) const;
  QString textOf(double value) const;
  void sliderMoved(int position);
  static constexpr int kNumberRoom = 46;  // "10,000" at the usual size of text [px]

  void numberTyped();
  bool dragged(QMouseEvent* event);
  void forgetRefusal();
  void showTips();
  bool logarithmic() const;
  void paintName(QPainter& painter) const;
  void paintRefusal(QPainter& painter) const;

  Parameter parameter_;
  std::string policy_;
  std::string inForce_;
  bool shown_ = false;
  double value_ = 0.0, base_ = 0.0;
  std::optional<std::int64_t> changedAt_;
  Slider* slider_ = nullptr;
  QLineEdit* number_ = nullptr;
  Combo* choice_ = nullptr;
  QToolButton* reset_ = nullptr;
  QString refusal_;
  QTimer forget_;
  std::optional<double> pressedAt_;  // [px] where a drag of the number began
  double dragFrom_ = 0.0;            // slider position where the drag began [slider steps]
  bool dragging_ = false;
};

}  // namespace surefoot
