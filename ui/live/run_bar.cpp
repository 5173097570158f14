// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/run_bar.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/support/counted.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "core/environment_library.h"
#include "ui/controls/bar_button.h"
#include "ui/controls/combo.h"
#include "ui/controls/slider.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/style/icons.h"
#include "ui/style/symbol_text.h"
#include "ui/style/theme.h"
#include "ui/support/plain_text.h"

namespace surefoot {

namespace {

constexpr double kSlowest = 0.1, kFastest = 8.0;  // times real time
constexpr int kIsEnvironment = Qt::UserRole + 1;  // data of an item: it is an environment, not a scenario
constexpr int kIsHead = -1;                       // data of a head between tasks

}  // namespace

double RunBar::paceAt(int position) {
  const double pace = kSlowest * std::pow(kFastest / kSlowest, static_cast<double>(position) / Slider::kSteps);
  return std::abs(pace - 1.0) < 0.06 ? 1.0 : pace;  // real time is easy to hit
}

int RunBar::positionOfPace(double pace) {
  return static_cast<int>(std::lround(Slider::kSteps * std::log(pace / kSlowest) / std::log(kFastest / kSlowest)));
}

RunBar::RunBar(RunningLife& life, Editing& editing, const RunActions& actions, QWidget* parent)
    : Painted(parent),
      life_(life),
      editing_(editing),
      actions_(actions) {
  auto* run = new BarButton(actions.run, Icon::Run, BarButton::Look::Main, this);
  buttons_ = {run, new BarButton(actions.step, Icon::Step, BarButton::Look::Quiet, this),
              new BarButton(actions.restart, Icon::Restart, BarButton::Look::Quiet, this)};
  pace_ = new Slider(this);
  pace_->setAccessibleName(tr("Pace"));
  pace_->setToolTip(
      tipText(tr("How fast the world runs while turbo is off: %1 to %2 times real time").arg(kSlowest).arg(kFastest)));
  pace_->setValue(positionOfPace(life.pace()));
  connect(pace_, &QSlider::valueChanged, this, [this](int position) { life_.setPace(paceAt(position)); });
  buttons_.push_back(new BarButton(actions.turbo, Icon::Turbo, BarButton::Look::Framed, this));

  task_ = new Combo(tr("Task"), this);
  fillTasks();
  connect(task_, &QComboBox::activated, this, [this](int i) {
    const std::string name = task_->itemData(i).toString().toStdString();
    const bool elsewhere = task_->itemData(i, kIsEnvironment).toBool();
    refresh();  // until it has begun
    if (elsewhere)
      Q_EMIT environmentAsked(name);
    else if (!name.empty())
      editing_.setScenario(name);
  });
  task_->setPlaceholderText(tr("Changed model"));
  agent_ = new Combo(tr("Learning rule"), this);
  fillAgents();
  connect(agent_, &QComboBox::activated, this, [this](int i) {
    const QString name = agent_->itemData(i).toString();
    refresh();  // until it is agreed to
    if (name.toStdString() != life_.configuration().names.agent) Q_EMIT agentAsked(name, agent_->itemText(i));
  });
  policy_ = new Combo(tr("Policy"), this);
  for (const auto& entry : life.registry().policies) {
    policy_->addItem(fromCore(entry.title), toText(entry.name));
    policy_->setItemData(policy_->count() - 1, tipOf(entry.name, entry.help), Qt::ToolTipRole);
  }
  connect(policy_, &QComboBox::activated, this,
          [this](int i) { editing_.setPolicy(policy_->itemData(i).toString().toStdString()); });

  connect(&life_, &RunningLife::stateChanged, this, [this, run] {
    run->setIcon(life_.running() ? Icon::Pause : Icon::Run);
    refresh();
  });
  connect(&life_, &RunningLife::parametersReplaced, this, [this] {
    fillTasks();
    fillAgents();
    refresh();
  });
  connect(&life_, &RunningLife::configurationChanged, this, &RunBar::refresh);
  for (const auto changed : {&RunningLife::valuesArrived, &RunningLife::replaced, &RunningLife::stateChanged})
    connect(&life_, changed, this, &RunBar::readNumbers);
  makeMeaning();
  whenScaled(this, [this] {
    setFixedHeight(scaled(48));
    policy_->setPolicyMarkers();
    fillTasks();
    refresh();
  });
  readNumbers();
}

/// Reads the numbers that the counters show; a screen reader gets them, too.
void RunBar::readNumbers() {
  const Numbers& now = life_.numbers();
  texts_ = {countNumber(static_cast<double>(now.falls)), countNumber(static_cast<double>(now.episodes)),
            life_.running() ? life_.factorText() : QString()};
  setAccessibleDescription(life_.task().canFall ? tr("%1 in %2").arg(fallsText(now.falls), episodesText(now.episodes))
                                                : episodesText(now.episodes));
  if (counterWidth(kNothing) != counterWidth_) layOut();
  update();
}

/// "?": a menu that explains the present choices of the three boxes.
void RunBar::makeMeaning() {
  meaning_ = new QToolButton(this);
  meaning_->setText(QStringLiteral("?"));
  meaning_->setAutoRaise(true);
  meaning_->setAccessibleName(tr("What do these words mean?"));
  meaning_->setToolTip(tr("What task, learning rule and policy mean"));
  auto* menu = new QMenu(meaning_);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const QComboBox* combo : {task_, agent_, policy_}) {
      const bool scenario = combo == task_ && !combo->itemData(combo->currentIndex(), kIsEnvironment).toBool();
      const std::string name =
          scenario ? life_.configuration().names.environment : combo->currentData().toString().toStdString();
      const surefoot::Word* word = wordOf(name);
      if (!word) continue;
      connect(menu->addAction(menuText(fromCore(word->title))), &QAction::triggered, this,
              [this, name] { Q_EMIT meaningAsked(name); });
    }
    menu->addSeparator();
    connect(menu->addAction(tr("All words")), &QAction::triggered, this, [this] { Q_EMIT meaningAsked({}); });
  });
  connect(meaning_, &QToolButton::clicked, menu,
          [this, menu] { menu->popup(meaning_->mapToGlobal(QPoint(0, meaning_->height()))); });
}

/// The scenarios of the environment, where it has any, and the other environments; each under a head of its own.
void RunBar::fillTasks() {
  const QSignalBlocker blocker(task_);
  task_->clear();
  const auto addHead = [&](const QString& text) {
    task_->addItem(text);
    const int i = task_->count() - 1;
    task_->setItemData(i, kIsHead, Qt::UserRole);
    task_->setItemData(i, 0, Qt::UserRole - 1);  // its flags: nothing to choose
    task_->setItemData(i, scaledFont(11, 500), Qt::FontRole);
  };
  const auto add = [&](const auto& entry, const std::string& name, bool isEnvironment) {
    task_->addItem(fromCore(entry.title), toText(name));
    task_->setItemData(task_->count() - 1, tipOf(entry.name, entry.help), Qt::ToolTipRole);
    task_->setItemData(task_->count() - 1, isEnvironment, kIsEnvironment);
  };
  const std::string& here = life_.configuration().names.environment;
  const auto scenarios = scenariosOf(life_.registry(), here);
  const bool any = !scenarios.empty();
  if (any) addHead(tr("Scenario of the model"));
  const auto file = life_.registry().files ? life_.registry().files->find(here) : nullptr;
  for (const AssignmentEntry* entry : scenarios) {
    add(*entry, entry->name, false);
    if (file)  // "Segway: bumpy floor": which robot it is stands nowhere else
      task_->setItemText(task_->count() - 1,
                         fromCore(file->entry.title) + QStringLiteral(": ") + fromCore(entry->title));
  }
  addHead(tr("Task"));
  for (const auto& entry : life_.registry().environments)
    if (entry.name != here)
      add(entry, entry.name, true);
    else if (!any)
      add(entry, "", false);
  addRobots(here, any);
  task_->view()->setMinimumWidth(task_->view()->sizeHintForColumn(0) + scaled(24));
}

/// The robots that come with the program as files, and the one in hand, wherever its file lies.
void RunBar::addRobots(const std::string& here, bool hasScenarios) {
  const auto& files = life_.registry().files;
  if (!files) return;
  const auto add = [&](const QString& title, const QString& name, bool isEnvironment) {
    task_->addItem(title, name);
    task_->setItemData(task_->count() - 1, isEnvironment, kIsEnvironment);
  };
  if (const auto file = files->find(here); file && !hasScenarios) add(fromCore(file->entry.title), QString(), false);
  for (const std::string& name : files->shelved()) {
    QString title = toText(name);
    title.replace(u'-', u' ').replace(0, 1, title.at(0).toUpper());
    if (name != plainName(here)) add(title, toText(name), true);
  }
}

void RunBar::fillAgents() {
  const QSignalBlocker blocker(agent_);
  agent_->clear();
  for (const auto& entry : life_.registry().agents) {
    if (entry.name == "scripted" && !life_.task().handMade) continue;  // nothing acts there
    agent_->addItem(fromCore(entry.title), toText(entry.name));
    agent_->setItemData(agent_->count() - 1, tipOf(entry.name, entry.help), Qt::ToolTipRole);
  }
}

void RunBar::changePace(int notches) {
  pace_->setValue(pace_->value() + notches * Slider::kSteps / 20);
}

void RunBar::refresh() {
  const Names& names = life_.configuration().names;
  const auto select = [](QComboBox& combo, const std::string& name) {
    const QSignalBlocker blocker(combo);
    combo.setCurrentIndex(combo.findData(toText(name)));
  };
  // A model that was changed by hand is none of the scenarios.
  const auto scenario = findScenario(life_.registry(), names.environment, names.scenario);
  bool asNamed = true;
  if (scenario)
    for (const auto& [key, value] : (*scenario)->values) asNamed &= life_.configuration().parameters.get(key) == value;
  task_->setToolTip(tipOf(names.environment, ""));
  agent_->setToolTip(tipOf(names.agent, ""));
  policy_->setToolTip(tipOf(names.policy, ""));
  select(*task_, asNamed ? names.scenario : "");
  select(*agent_, names.agent);
  select(*policy_, names.policy);
  if (!pace_->isSliderDown()) {
    const QSignalBlocker blocker(pace_);
    if (paceAt(pace_->value()) != life_.pace()) pace_->setValue(positionOfPace(life_.pace()));
  }
  layOut();
}

}  // namespace surefoot

#include "moc_run_bar.cpp"
