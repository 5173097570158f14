// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/panel_row.h"

#include <QSignalBlocker>
#include <QSplitter>
#include <QTabBar>
#include <QVBoxLayout>

#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/style/scale.h"

namespace surefoot {

namespace {
constexpr int kLeastWidth = 240;  // [px] of a panel beside another, at the usual text size
}

PanelRow::PanelRow(QWidget* parent)
    : QWidget(parent),
      tabs_(new QTabBar(this)),
      full_(new LinkButton(tr("Full size"), this)),
      splitter_(new QSplitter(Qt::Horizontal, this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->addWidget(tabs_, 1);
  row->addWidget(full_);
  column->addLayout(row);
  column->addWidget(splitter_, 1);
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setAccessibleName(tr("Panels that share this place"));
  connect(full_, &QToolButton::clicked, this, [this] { Q_EMIT fullSizeAsked(shown_.value(tabs_->currentIndex())); });
  splitter_->setHandleWidth(1);
  splitter_->setChildrenCollapsible(false);
  connect(tabs_, &QTabBar::currentChanged, this, &PanelRow::layOut);
  whenScaled(this, [this] { layOut(); });
}

void PanelRow::add(QWidget* panel, const QString& title) {
  panel->setWindowTitle(title);
  panel->hide();
  splitter_->addWidget(panel);
}

void PanelRow::show(const QList<QWidget*>& panels) {
  if (panels == shown_) return layOut();
  shown_ = panels;
  const QSignalBlocker blocker(tabs_);
  while (tabs_->count() > 0) tabs_->removeTab(0);
  for (const QWidget* panel : shown_) tabs_->addTab(panel->windowTitle());
  layOut();
}

bool PanelRow::holds(const QWidget* panel) const {
  return splitter_->isAncestorOf(panel);
}

void PanelRow::layOut() {
  const bool narrow = shown_.size() > 1 && width() < scaled(kLeastWidth) * shown_.size();
  tabs_->setVisible(narrow);
  full_->setVisible(narrow);
  for (int i = 0; i < splitter_->count(); ++i) {
    const auto place = shown_.indexOf(splitter_->widget(i));
    splitter_->widget(i)->setVisible(place >= 0 && (!narrow || place == tabs_->currentIndex()));
    // The tab says the title.
    if (auto* header = splitter_->widget(i)->findChild<PanelHeader*>())
      header->setVisible(!narrow || header->hasWidget());
  }
}

void PanelRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layOut();
}

}  // namespace surefoot

#include "moc_panel_row.cpp"
