// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Live page that says where its panels stand.
#include <QAction>
#include <QCryptographicHash>

#include "ui/controls/panel.h"
#include "ui/live/live_page.h"
#include "ui/live/world/world_view.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"

namespace surefoot {

// Not by saveState() and restoreState(): they break while a dock is on its way.
void LivePage::toggleFull(QWidget* panel) {
  const bool back = full_ != nullptr;
  if (back) {
    centralWidget()->show();
    QList<QDockWidget*> docks;
    QList<int> widths, heights;
    for (const auto& [shown, size] : before_) {
      shown->show();
      docks << shown, widths << size.width(), heights << size.height();
    }
    resizeDocks(docks, widths, Qt::Horizontal);
    resizeDocks(docks, heights, Qt::Vertical);
  } else {
    before_.clear();
    for (Panel* other : panels_) {
      if (other->isVisible()) before_.emplace_back(other, other->size());
      other->setVisible(other == panel);
    }
    centralWidget()->setVisible(panel == centralWidget());
  }
  full_ = back ? nullptr : panel;
  worldHeader_->setFull(full_ == centralWidget());
  for (Panel* p : panels_) p->header().setFull(full_ == p);
  keepFocus();
}

bool LivePage::leaveFullSize() {
  if (!full_) return false;
  toggleFull(full_);
  return true;
}

// A hidden widget passes the focus on to the next one, in the end to a page tab, which would keep the window's keys.
void LivePage::keepFocus() {
  if (!isVisible()) return;
  auto* panel = qobject_cast<Panel*>(full_);
  QWidget* home = panel ? panel->widget() : world_;
  home->setFocus(Qt::OtherFocusReason);
}

// Named layouts: the usual one, and one each for teaching, falls and maps.
void LivePage::useLayout(Layout layout) {
  layout_ = layout;
  resetLayout();
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  switch (layout) {
    case Layout::Usual:
      return keepFocus();
    case Layout::Teaching:
      // Shows the parameters, a large robot, the last step and the results; the maps are hidden at first.
      for (const char* name : {"maps", "actions"}) panel(name)->hide();
      for (Panel* p : {steps_, rule_}) p->show();
      addDockWidget(Qt::BottomDockWidgetArea, steps_);
      addDockWidget(Qt::RightDockWidgetArea, rule_);
      resizeDocks({steps_}, {scaled(180)}, Qt::Vertical);
      resizeDocks({panel("parameters"), panel("reward")}, {scaled(264), scaled(400)}, Qt::Horizontal);
      resizeDocks({panel("reward"), panel("falls"), rule_}, {scaled(230), scaled(230), scaled(180)}, Qt::Vertical);
      break;
    case Layout::Falls:
      panel("parameters")->hide();
      list_->show();
      break;
    case Layout::Maps:
      for (const char* name : {"parameters", "reward", "falls"}) panel(name)->hide();
      resizeDocks({panel("maps")}, {width() * 6 / 10}, Qt::Horizontal);
      break;
    case Layout::Signals:
      useSignals();
      break;
  }
  untouched_ = false;
  followTask();
  keepFocus();
}

void LivePage::resetLayout() {
  if (full_) toggleFull(full_);
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  for (Panel* p : panels_) {
    p->setFloating(false);
    p->show();
  }
  addDockWidget(Qt::LeftDockWidgetArea, panel("parameters"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("actions"));
  addDockWidget(Qt::RightDockWidgetArea, panel("maps"));
  addDockWidget(Qt::RightDockWidgetArea, panel("reward"));
  addDockWidget(Qt::RightDockWidgetArea, panel("falls"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("step"));
  addDockWidget(Qt::BottomDockWidgetArea, panel("rule"));
  addDockWidget(Qt::RightDockWidgetArea, panel("list"));
  for (Panel* extra : {signals_, strides_}) addDockWidget(Qt::RightDockWidgetArea, extra);
  addDockWidget(Qt::BottomDockWidgetArea, portrait_);
  // Panels that are hidden at first share the place of a visible one, or they would cut each other.
  for (Panel* extra : {steps_, rule_}) tabifyDockWidget(panel("actions"), extra);
  tabifyDockWidget(panel("falls"), list_);
  for (Panel* extra : {steps_, rule_, list_, signals_, strides_, portrait_}) extra->hide();
  for (const char* front : {"actions", "falls"}) panel(front)->raise();
  needless_.clear();
  followTask();
  untouched_ = true;
  shareSpace();
}

/// A task without falls needs no panels for them.
void LivePage::followTask() {
  const bool falls = session_.life().task().canFall;
  if (full_) return;
  for (const char* name : {"falls", "list"}) {
    auto* panel = findChild<Panel*>(QLatin1String(name));
    panel->toggleViewAction()->setEnabled(falls);
    if (!falls && !panel->isHidden()) needless_.push_back(panel), panel->hide();
  }
  if (!falls) return;
  for (Panel* panel : needless_) panel->show();
  if (!needless_.empty()) needless_.front()->raise();
  needless_.clear();
}

void LivePage::shareSpace() {
  // The columns of the 1280 px window are 264, 576 and 440; a wider one gives most to the middle.
  const auto panel = [this](const char* name) { return findChild<Panel*>(QLatin1String(name)); };
  const bool wide = width() >= scaled(1800), narrow = width() < scaled(1200);
  resizeDocks({panel("parameters"), panel("maps")},
              {scaled(wide ? 288 : 264), scaled(wide     ? 632
                                                : narrow ? 344
                                                         : 440)},
              Qt::Horizontal);
  resizeDocks({panel("actions")}, {scaled(268)}, Qt::Vertical);
  resizeDocks({panel("maps"), panel("reward"), panel("falls")},
              {scaled(wide ? 440 : 300), scaled(wide ? 288 : 196), scaled(wide ? 274 : 190)}, Qt::Vertical);
}

// A column that was made wider by hand keeps its share.
void LivePage::followTextSize() {
  const double factor = textSize() / sizedFor_;
  sizedFor_ = textSize();
  if (!laidOut_ || full_ || factor == 1) return;
  if (untouched_) return shareSpace();
  QList<QDockWidget*> docks;
  QList<int> widths;
  for (const char* name : {"parameters", "maps"})
    if (auto* panel = findChild<Panel*>(QLatin1String(name)); panel->isVisible() && !panel->isFloating())
      docks << panel, widths << static_cast<int>(panel->width() * factor);
  resizeDocks(docks, widths, Qt::Horizontal);
}

namespace {

/// Qt does not check the numbers of a layout: a layout that was damaged on the disk ends the program. So each carries
/// its hash.
QByteArray hashOf(const QByteArray& state) {
  return QCryptographicHash::hash(state, QCryptographicHash::Sha256);
}

}  // namespace

QByteArray LivePage::layoutState() {
  if (full_) toggleFull(full_);
  const QByteArray state = saveState(kLayoutVersion);
  return hashOf(state) + state;
}

bool LivePage::restoreLayout(const QByteArray& layout) {
  const qsizetype length = QCryptographicHash::hashLength(QCryptographicHash::Sha256);
  const QByteArray state = layout.mid(length);
  laidOut_ = layout.left(length) == hashOf(state) && restoreState(state, kLayoutVersion);
  if (laidOut_) followTask();
  untouched_ = !laidOut_;
  return laidOut_;
}

}  // namespace surefoot
