// SPDX-License-Identifier: GPL-3.0-or-later
// One figure of an experiment with a header from which it is chosen.
#pragma once

#include <QWidget>

#include "core/recipes/figure.h"

namespace surefoot {

class Experiment;
class FigureView;
class LinkButton;
class PanelHeader;

class FigurePanel final : public QWidget {
  Q_OBJECT

 public:
  /// Begins with the figure of this number.
  FigurePanel(Experiment& experiment, std::size_t first, QWidget* parent = nullptr);
  FigureView& view() { return *view_; }
  PanelHeader& header() { return *header_; }
  /// The numbers of the figure; empty: nothing is drawn yet.
  std::string asCsv() const;

 private:
  void fillMenu();
  void refresh();

  Experiment& experiment_;
  PanelHeader* header_;
  LinkButton* choose_;
  FigureView* view_;
  std::size_t first_;
  std::string chosen_;  // name of the chosen figure
};

}  // namespace surefoot
