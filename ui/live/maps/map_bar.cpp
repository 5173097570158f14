// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/maps/map_bar.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <QWidgetAction>
#include <cmath>

#include "ui/controls/link_button.h"
#include "ui/controls/panel.h"
#include "ui/controls/slider.h"
#include "ui/language/from_core.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"
#include "ui/support/plain_text.h"

namespace surefoot {

MapBar::MapBar(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [row] { row->setSpacing(scaled(2)); });
  quantity_ = addButton(tr("Quantity"), &MapBar::fillQuantities);
  axes_ = addButton(tr("Axes"), &MapBar::fillAxes);
  others_ = addButton(tr("Other variables"), &MapBar::fillOthers);
  range_ = addButton(tr("Range of the colours"), &MapBar::fillRange);
  all_ = addButton(tr("What the map shows"), &MapBar::fillAll);
  all_->setText(tr("Map"));
  all_->hide();
}

bool MapBar::matters(const QToolButton* button) const {
  return button == axes_ ? task_.state.size() > 1 : button != others_ || task_.state.size() > 2;
}

void MapBar::fold(int room) {
  int needed = -2;
  for (QToolButton* button : {quantity_, axes_, others_, range_})
    if (matters(button)) needed += button->sizeHint().width() + 2;
  const bool folded = needed > room;
  for (QToolButton* button : {quantity_, axes_, others_, range_}) button->setVisible(!folded && matters(button));
  all_->setVisible(folded);
  layout()->invalidate();
}

void MapBar::fillAll(QMenu& menu) {
  const std::pair<QToolButton*, Fill> parts[] = {{quantity_, &MapBar::fillQuantities},
                                                 {axes_, &MapBar::fillAxes},
                                                 {others_, &MapBar::fillOthers},
                                                 {range_, &MapBar::fillRange}};
  for (const auto& [button, fill] : parts) {
    if (!matters(button)) continue;
    QMenu* own = menu.addMenu(QStringLiteral("%1: %2").arg(button->toolTip(), plainSymbols(button->text())));
    (this->*fill)(*own);
  }
}

QToolButton* MapBar::addButton(const QString& name, Fill fill) {
  auto* button = new LinkButton(QString(), this);
  button->setAccessibleName(name);
  button->setToolTip(tipText(name));
  auto* menu = new QMenu(button);
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  connect(menu, &QMenu::aboutToShow, this, [this, menu, fill] {
    menu->clear();
    (this->*fill)(*menu);
  });
  layout()->addWidget(button);
  return button;
}

void MapBar::setText(QToolButton* button, const QString& text) {
  if (button->text() == text) return;
  button->setText(text);
  button->updateGeometry();
}

void MapBar::show(const MapChoice& choice, const Task& task, std::span<const double> live, bool risk) {
  risk_ = risk;
  choice_ = choice;
  task_ = task;
  live_.assign(live.begin(), live.end());
  setText(quantity_, quantityText(choice, task));
  setText(axes_, axesText(choice, task));
  setText(others_, othersText(choice, task, live));
  setText(range_, choice.locked ? tr("locked") : tr("automatic"));
  if (auto* header = qobject_cast<PanelHeader*>(parentWidget())) header->layOutExtra();
}

void MapBar::choose(const MapChoice& choice) {
  Q_EMIT chosen(choice);
}

namespace {
QAction* addChoice(QMenu& menu, const QString& text, bool checked, std::function<void()> then) {
  QAction* action = menu.addAction(text);
  action->setCheckable(true);
  action->setChecked(checked);
  QObject::connect(action, &QAction::triggered, &menu, std::move(then));
  return action;
}
}  // namespace

void MapBar::fillQuantities(QMenu& menu) {
  if (task_.state.empty()) return;
  const auto add = [&](MapQuantity quantity, Action action) {
    MapChoice next = choice_;
    next.quantity = quantity;
    next.action = action;
    const bool numbered = quantity == MapQuantity::OneAction || quantity == MapQuantity::GreedyAction;
    const bool now = choice_.quantity == quantity && (!numbered || choice_.action == action);
    addChoice(menu, quantityText(next, task_), now, [this, next] { choose(next); });
  };
  add(MapQuantity::BestAction, 0);
  constexpr std::size_t kMostActions = 12;  // more would fill the screen; the best one and the greedy one remain
  if (task_.actions.size() <= kMostActions)
    for (std::size_t a = task_.actions.size(); a-- > 0;) add(MapQuantity::OneAction, static_cast<Action>(a));
  menu.addSeparator();
  for (std::size_t j = 0; j < std::max<std::size_t>(1, task_.actionVariables.size()); ++j)
    add(MapQuantity::GreedyAction, static_cast<Action>(j));
  if (risk_) add(MapQuantity::Risk, 0);
  for (const MapQuantity q : {MapQuantity::Visits, MapQuantity::Eligibility}) add(q, 0);
}

void MapBar::fillAxes(QMenu& menu) {
  if (task_.state.empty()) return;
  for (const bool horizontal : {true, false}) {
    menu.addSection(horizontal ? tr("Horizontal") : tr("Vertical"));
    for (std::size_t d = 0; d < task_.state.size(); ++d) {
      MapChoice next = choice_;
      int& axis = horizontal ? next.x : next.y;
      int& other = horizontal ? next.y : next.x;
      if (other == static_cast<int>(d)) other = axis;  // they change places
      axis = static_cast<int>(d);
      addChoice(menu, fromCore(task_.state[d].title), (horizontal ? choice_.x : choice_.y) == static_cast<int>(d),
                [this, next] { choose(next); });
    }
  }
}

void MapBar::fillOthers(QMenu& menu) {
  if (task_.state.empty()) return;
  std::vector<std::size_t> others;
  for (std::size_t d = 0; d < task_.state.size(); ++d)
    if (!choice_.isAxis(d)) others.push_back(d);
  for (const std::size_t d : others) {
    QMenu* own = others.size() == 1 ? &menu : menu.addMenu(fromCore(task_.state[d].title));
    addOther(*own, d);
  }
}

void MapBar::addOther(QMenu& menu, std::size_t d) {
  const auto with = [&](Across how, Projection projection) {
    MapChoice next = choice_;
    next.across[d] = how;
    next.projection = projection;
    if (how == Across::Fixed && d < live_.size()) next.fixed[d] = live_[d];
    return next;
  };
  const auto add = [&](const QString& text, Across how, Projection projection) {
    const MapChoice next = with(how, projection);
    const bool now = choice_.across[d] == how && (how != Across::Projected || choice_.projection == projection);
    addChoice(menu, text, now, [this, next] { choose(next); });
  };
  add(tr("Follow the live state"), Across::Live, choice_.projection);
  add(tr("Fix where it is now"), Across::Fixed, choice_.projection);

  const StateVariable v = task_.state[d];
  auto* slider = new Slider(&menu);
  slider->setMinimumWidth(scaled(180));
  slider->setAccessibleName(tr("Fixed %1").arg(fromCore(v.title)));
  const auto whole = [v](double value) { return v.whole ? std::round(value) : value; };
  const double now = choice_.across[d] == Across::Fixed ? choice_.fixed[d] : d < live_.size() ? live_[d] : 0.0;
  slider->setValue(static_cast<int>(Slider::kSteps * (now - v.viewLow) / (v.viewHigh - v.viewLow)));
  connect(slider, &QSlider::valueChanged, this, [this, d, v, whole](int position) {
    MapChoice next = choice_;
    next.across[d] = Across::Fixed;
    next.fixed[d] = whole(v.viewLow + (v.viewHigh - v.viewLow) * position / Slider::kSteps);
    choose(next);
  });
  auto* action = new QWidgetAction(&menu);
  action->setDefaultWidget(slider);
  menu.addAction(action);

  menu.addSeparator();
  add(tr("Mean over it"), Across::Projected, Projection::Mean);
  add(tr("Least over it"), Across::Projected, Projection::Least);
  add(tr("Most over it"), Across::Projected, Projection::Most);
}

void MapBar::fillRange(QMenu& menu) {
  for (const bool locked : {true, false}) {
    MapChoice next = choice_;
    next.locked = locked;
    addChoice(menu, locked ? tr("Locked to what rewards allow") : tr("What the map shows now"),
              choice_.locked == locked, [this, next] { choose(next); });
  }
}

}  // namespace surefoot

#include "moc_map_bar.cpp"
