// SPDX-License-Identifier: GPL-3.0-or-later
// This step: what the last step taught, in words and numbers (Sutton & Barto 2018, section 12.7).
#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "core/experiment/snapshot.h"

class QPainter;

namespace surefoot {

class Session;

class StepView final : public QWidget {
  Q_OBJECT

 public:
  explicit StepView(Session& session, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {576, 200}; }
  QSize minimumSizeHint() const override { return {380, 150}; }
  /// The same as text, for those who listen.
  QStringList sentences() const;

 protected:
  void paintEvent(QPaintEvent*) override;

 private:
  void nextFrame();

  Session& session_;
  Snapshot shown_;
  QElapsedTimer sinceUpdate_;
};

/// The rule of thumb for TRL's threshold, with its n* and its limits (thesis, section 4.3), from the episodes so far.
class RuleView final : public QWidget {
  Q_OBJECT

 public:
  explicit RuleView(Session& session, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {300, 200}; }
  QSize minimumSizeHint() const override { return {240, 150}; }

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void use();
  Session& session_;
};

}  // namespace surefoot
