// SPDX-License-Identifier: GPL-3.0-or-later
// The panels with results: two figures, and below them the table with the sentence.
#include <QKeyEvent>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/experiment/claims_table.h"
#include "ui/experiment/experiment_page.h"
#include "ui/experiment/figure_panel.h"
#include "ui/experiment/findings_table.h"
#include "ui/style/scale.h"

namespace surefoot {

QWidget* ExperimentPage::makeResults() {
  auto* upper = new QSplitter(Qt::Horizontal);
  upper->setHandleWidth(1);
  upper->setChildrenCollapsible(false);
  for (const std::size_t first : {0, 1}) {
    figures_.push_back(new FigurePanel(experiment_, first));
    upper->addWidget(figures_.back());
    panels_.push_back({figures_.back(), &figures_.back()->header()});
  }
  upper_ = upper;
  auto* lower = new QStackedWidget;
  lower->addWidget(new FindingsTable(experiment_));
  auto* claims = new ClaimsTable(experiment_);
  lower->addWidget(claims);
  auto* whole = new QSplitter(Qt::Vertical);
  whole->setHandleWidth(1);
  whole->setChildrenCollapsible(false);
  whole->addWidget(upper);
  auto* table = new QWidget;
  auto* column = new QVBoxLayout(table);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* header = new PanelHeader(tr("Table"), true);
  auto* other = new LinkButton(tr("The thesis's claims"));
  header->addWidget(other);
  header->setHelp(QStringLiteral("statistics"));
  const auto turn = [this, lower, header, other](int page) {
    lower->setCurrentIndex(page);
    const bool soFar = experiment_.view() && !experiment_.view()->findings.complete;
    const QString what = page == 0 ? tr("falls during learning, against the reference of each condition")
                                   : tr("what the thesis claims, and what came out here");
    header->setNote(soFar ? tr("so far · %1").arg(what) : what);
    other->setText(page == 0 ? tr("The thesis's claims") : tr("The conditions"));
    header->layOutExtra();
  };
  connect(other, &QToolButton::clicked, this, [lower, turn] { turn(1 - lower->currentIndex()); });
  const auto offer = [claims, lower, other, header, turn] {
    turn(claims->rowCount() == 0 ? 0 : lower->currentIndex());
    other->setEnabled(claims->rowCount() > 0);
    if (claims->rowCount() == 0) other->setText({});
    header->layOutExtra();
  };
  connect(&experiment_, &Experiment::resultsChanged, claims, offer);
  offer();
  summary_ = new QLabel;
  summary_->setTextFormat(Qt::RichText);  // its names are escaped
  whenScaled(summary_, [this] { summary_->setContentsMargins(scaled({12, 6, 12, 10})); });
  summary_->setWordWrap(true);
  column->addWidget(header);
  column->addWidget(lower, 1);
  column->addWidget(summary_);
  whole->addWidget(table);
  panels_.push_back({table, header});
  for (const auto& [panel, head] : panels_)
    connect(head, &PanelHeader::fullSizeAsked, this, [this, panel = panel] { setFull(panel); });
  whole->setSizes({380, 300});
  return whole;
}

/// One panel has the whole place, or, asked again, all have theirs.
void ExperimentPage::setFull(QWidget* panel) {
  full_ = full_ == panel ? nullptr : panel;
  for (const auto& [each, header] : panels_) {
    each->setVisible(!full_ || each == full_);
    header->setFull(each == full_);
  }
  upper_->setVisible(full_ != panels_.back().first);
  if (isVisible()) setFocus(Qt::OtherFocusReason);  // a hidden widget would pass the focus on to any other
}

void ExperimentPage::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape || !full_) return QWidget::keyPressEvent(event);
  setFull(full_);
}

}  // namespace surefoot
