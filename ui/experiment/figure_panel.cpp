// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/figure_panel.h"

#include <QMenu>
#include <QVBoxLayout>

#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/view_menu.h"
#include "ui/experiment/experiment.h"
#include "ui/experiment/figures/condition_name.h"
#include "ui/experiment/figures/figure_view.h"
#include "ui/language/from_core.h"
#include "ui/support/plain_text.h"

namespace surefoot {

FigurePanel::FigurePanel(Experiment& experiment, std::size_t first, QWidget* parent)
    : QWidget(parent),
      experiment_(experiment),
      header_(new PanelHeader(tr("Figure"), true, this)),
      choose_(new LinkButton(tr("Another figure"))),
      view_(new FigureView({}, this)),
      first_(first) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(view_, 1);
  view_->setTitleShown(false);
  new ViewMenu(*view_, [this] { return asCsv(); });
  auto* menu = new QMenu(choose_);
  choose_->setMenu(menu);
  choose_->setPopupMode(QToolButton::InstantPopup);
  header_->addWidget(choose_);
  header_->setHelp(QStringLiteral("page-experiment"));
  connect(menu, &QMenu::aboutToShow, this, &FigurePanel::fillMenu);
  connect(&experiment_, &Experiment::planChanged, this, [this] {
    chosen_.clear();
    refresh();
  });
  connect(&experiment_, &Experiment::resultsChanged, this, &FigurePanel::refresh);
  connect(&experiment_, &Experiment::stateChanged, this, &FigurePanel::refresh);
  connect(&experiment_, &Experiment::chosenChanged, this, [this] { view_->setChosen(experiment_.chosen()); });
  connect(view_, &FigureView::clicked, this, [this](const QString& condition) {
    const std::string name = condition.toStdString();
    experiment_.choose(experiment_.chosen() == name ? "" : name);
  });
  refresh();
}

void FigurePanel::fillMenu() {
  choose_->menu()->clear();
  for (const FigureSpec& spec : experiment_.figures()) {
    QAction* action = choose_->menu()->addAction(menuText(shownName(fromCore(spec.title).toStdString())));
    action->setCheckable(true);
    action->setChecked(spec.name == chosen_);
    connect(action, &QAction::triggered, this, [this, name = spec.name] {
      chosen_ = name;
      refresh();
    });
  }
}

void FigurePanel::refresh() {
  const auto& figures = experiment_.figures();
  if (chosen_.empty() && figures.size() > first_) chosen_ = figures[first_].name;
  const auto spec = std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.name == chosen_; });
  choose_->setEnabled(!figures.empty());
  if (spec == figures.end()) {
    header_->setTitle(tr("Figure"));
    return view_->setFigure({}, experiment_.whyNoResults());
  }
  header_->setTitle(shownName(fromCore(spec->title).toStdString()));
  const bool soFar = experiment_.view() && !experiment_.view()->findings.complete;
  const QString what = spec->kind == "bars" ? tr("mean and 95 % interval") : tr("mean and 95 % band");
  header_->setNote(soFar ? tr("so far · %1").arg(what) : what);
  experiment_.look(first_, *spec);
  if (const Figure* figure = experiment_.figureAt(*spec))
    view_->setFigure(*figure, {});
  else if (!experiment_.view() || view_->figure().name != spec->name)
    view_->setFigure({}, experiment_.isMaking() ? tr("It is being drawn.") : experiment_.whyNoResults());
}

std::string FigurePanel::asCsv() const {
  return view_->asCsv();
}

}  // namespace surefoot

#include "moc_figure_panel.cpp"
