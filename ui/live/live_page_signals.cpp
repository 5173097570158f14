// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the Live page that shows how the robot moves: strip charts, phase portrait, strides.
#include <QMenu>
#include <QScrollArea>
#include <algorithm>

#include "core/signals/strides.h"
#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/view_menu.h"
#include "ui/live/live_page.h"
#include "ui/live/signals/phase_portrait.h"
#include "ui/live/signals/signals_bar.h"
#include "ui/live/signals/signals_shown.h"
#include "ui/live/signals/stride_table.h"
#include "ui/live/signals/strip_charts.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"

namespace surefoot {

void LivePage::makeSignals() {
  auto* shown = new SignalsShown(session_.life(), session_.looking(), this);
  auto* charts = new StripCharts(*shown);
  auto* scrolled = new QScrollArea;
  scrolled->setWidgetResizable(true);
  scrolled->setFrameShape(QFrame::NoFrame);
  scrolled->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scrolled->setFocusPolicy(Qt::NoFocus);
  scrolled->setWidget(charts);
  signals_ = addPanel(tr("Signals"), "signals", scrolled, Qt::RightDockWidgetArea);
  auto* menu = new ViewMenu(*charts);
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

/// The world at the left with the phase portrait below it, signals and strides beside.
void LivePage::useSignals() {
  for (Panel* p : panels_) p->hide();
  const auto signals = session_.life().environment().signals();
  const bool walks =
      std::any_of(signals.begin(), signals.end(), [](const Signal& s) { return footOf(s) != Foot::None; });
  for (Panel* p : {signals_, portrait_}) p->show();
  strides_->setVisible(walks);
  addDockWidget(Qt::RightDockWidgetArea, signals_);
  addDockWidget(Qt::RightDockWidgetArea, strides_);
  addDockWidget(Qt::BottomDockWidgetArea, portrait_);
  resizeDocks({signals_}, {width() * 68 / 100}, Qt::Horizontal);
  resizeDocks({signals_, strides_}, {height() * 77 / 100, height() * 23 / 100}, Qt::Vertical);
  resizeDocks({portrait_}, {height() * 50 / 100}, Qt::Vertical);
}

}  // namespace surefoot
