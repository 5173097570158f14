// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Live page that shows how the robot moves: strip charts, phase portrait, strides.
#include <QLayout>
#include <QMenu>
#include <algorithm>

#include "core/signals/strides.h"
#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/view_menu.h"
#include "ui/live/live_page.h"
#include "ui/live/rival.h"
#include "ui/live/signals/phase_portrait.h"
#include "ui/live/signals/scrolled_strips.h"
#include "ui/live/signals/signals_bar.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/live/signals/stride_table.h"
#include "ui/live/signals/strip_charts.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"

namespace surefoot {

void LivePage::makeSignals() {
  auto* shown = signalsShown_ = new SignalsShown(session_.life(), session_.looking(), this);
  auto* scrolled = new ScrolledStrips(*shown);
  signals_ = addPanel(tr("Signals"), "signals", scrolled, Qt::RightDockWidgetArea);
  auto* menu = scrolled->charts().findChild<ViewMenu*>();
  auto* bar = signalsBar_ = new SignalsBar(session_.life(), session_.looking(), *shown);
  signals_->header().addWidget(bar);
  connect(bar, &SignalsBar::refused, this, &LivePage::refused);
  connect(bar, &SignalsBar::filmAsked, this, &LivePage::filmAsked);
  connect(bar, &SignalsBar::exportAsked, menu, &ViewMenu::exportAs);
  const auto note = [this, bar] { signals_->header().setNote(bar->note()); };
  connect(shown, &SignalsShown::changed, this, note);

  auto* portrait = new PhasePortrait(*shown);
  portrait_ = addPanel(tr("Phase portrait"), "portrait", portrait, Qt::BottomDockWidgetArea);
  auto* axes = new LinkButton(tr("Signals"));
  axes->setAccessibleName(tr("Signals of the axes"));
  auto* axesMenu = new QMenu(axes);
  axes->setMenu(axesMenu);
  axes->setPopupMode(QToolButton::InstantPopup);
  connect(axesMenu, &QMenu::aboutToShow, this, [axesMenu, portrait] {
    axesMenu->clear();
    portrait->fillAxis(*axesMenu->addMenu(tr("Horizontal")), true);
    portrait->fillAxis(*axesMenu->addMenu(tr("Vertical")), false);
  });
  portrait_->header().addWidget(axes);
  connect(shown, &SignalsShown::changed, this, [this, axes, portrait] {
    if (axes->text() == portrait->axesText()) return;
    axes->setText(portrait->axesText());
    portrait_->header().layOutExtra();
  });

  strides_ = addPanel(tr("Strides"), "strides", new StrideTable(*shown), Qt::RightDockWidgetArea);
  strides_->header().setNote(tr("two steps each; a click marks one in the signals"));
}

void LivePage::rollOut() {
  if (!signals_->isVisible()) useLayout(Layout::Signals);
  signalsBar_->rollOut();
}

void LivePage::setSecond(const QString& path) {
  signalsBar_->setSecond(path, false);
}

/// The world at the left with the phase portrait below it, signals and strides beside.
void LivePage::useSignals() {
  for (Panel* p : panels_) p->hide();
  const auto signals = session_.life().environment().signals();
  const bool walks =
      std::any_of(signals.begin(), signals.end(), [](const Signal& s) { return footOf(s) != Foot::None; });
  for (Panel* p : {signals_, portrait_}) p->show();
  strides_->setVisible(walks);
  addDockWidget(Qt::RightDockWidgetArea, signals_);
  shareSpaceOfSignals();
}

/// Two worlds get more of it than one. Where the phase portrait has no room below the world, all panels share one
/// place: the page would scroll, and the time axis with it.
void LivePage::shareSpaceOfSignals() {
  const int room = parentWidget() ? parentWidget()->height() : height();
  centralWidget()->layout()->activate();
  if (centralWidget()->minimumSizeHint().height() + portrait_->minimumSizeHint().height() <= room) {
    addDockWidget(Qt::RightDockWidgetArea, strides_);
    addDockWidget(Qt::BottomDockWidgetArea, portrait_);
  } else {
    for (Panel* other : {strides_, portrait_}) tabifyDockWidget(signals_, other);
    signals_->raise();
  }
  resizeDocks({signals_}, {width() * (rival_ ? 58 : 68) / 100}, Qt::Horizontal);
  resizeDocks({signals_, strides_}, {height() * 77 / 100, height() * 23 / 100}, Qt::Vertical);
  resizeDocks({portrait_}, {height() * (rival_ ? 28 : 50) / 100}, Qt::Vertical);
}

void LivePage::showSignalsOfSecond() {
  LifeBeside beside;
  if (rival_)
    beside = {&rival_->session().life(), &rival_->session().looking(), [rival = rival_] { return rival->later(); }};
  signalsShown_->setBeside(std::move(beside));
  if (layout_ == Layout::Signals && !full_) shareSpaceOfSignals();
}

}  // namespace surefoot
