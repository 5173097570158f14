// SPDX-License-Identifier: GPL-3.0-or-later
// Falls over pushes and models as colours: a column a push, a row a model, two Q-functions beside each other. A cell
// says what share of its trials fell, with the 95 % interval where there is room; where the intervals of two have
// nothing in common, it is framed. The mouse or the arrow keys choose a cell, of which spoken() tells more. A task in
// which nothing can fall shows its successes.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "core/robustness/robustness.h"
#include "ui/style/painted.h"
#include "ui/support/exporting.h"

namespace surefoot {

class RobustnessMap final : public Painted<>, public CsvSource {
  Q_OBJECT

 public:
  explicit RobustnessMap(QWidget* parent = nullptr);
  void show(std::shared_ptr<const Robustness> robustness);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// What is said of the chosen cell, a line a Q-function; empty: no cell is chosen.
  QStringList spoken() const;

  std::string asCsv() const override;
  void prepareExport(bool exporting) override;

 Q_SIGNALS:
  void chosen();  ///< another cell, or none

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QString conditions() const;
  /// Where things are: all maps have the same rows and columns.
  struct Layout {
    double labels = 0, cell = 0, row = 0, between = 0;
    std::size_t columns = 0, rows = 0;
    QRectF map(std::size_t function) const;
    QRectF at(std::size_t function, std::size_t model, std::size_t push) const;
  };
  struct Chosen {
    std::size_t model = 0, push = 0;
    bool operator==(const Chosen&) const = default;
  };

  Layout layOut() const;
  int leastHeight() const;
  std::optional<Chosen> cellAt(QPointF at) const;
  void choose(std::optional<Chosen> cell);
  void move(int columns, int rows);
  void showChosen();
  void paintMap(QPainter& p, const Layout& l, std::size_t function) const;
  void paintCell(QPainter& p, const Layout& l, const QRectF& where, const Tally& tally) const;
  void paintHeads(QPainter& p, const Layout& l, std::size_t function) const;
  void paintRows(QPainter& p, const Layout& l) const;
  void paintFoot(QPainter& p, const Layout& l) const;
  void paintScale(QPainter& p, QPointF at) const;

  std::shared_ptr<const Robustness> robustness_;  // null: nothing yet
  std::optional<Chosen> chosen_;
  bool exporting_ = false;
};

}  // namespace surefoot
