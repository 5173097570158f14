// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/run_bar.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <cmath>

#include "core/text.h"
#include "ui/bar_button.h"
#include "ui/combo.h"
#include "ui/icons.h"
#include "ui/session.h"
#include "ui/slider.h"
#include "ui/symbol_text.h"
#include "ui/theme.h"

namespace surefoot {

namespace {

constexpr double kSlowest = 0.1, kFastest = 8.0;  // times real time
constexpr int kButton = 32;
constexpr int kIsEnvironment = Qt::UserRole + 1;  // of a task

double paceAt(int position) {
  const double pace = kSlowest * std::pow(kFastest / kSlowest, static_cast<double>(position) / Slider::kSteps);
  return std::abs(pace - 1.0) < 0.06 ? 1.0 : pace;  // real time is easy to hit
}
int positionOf(double pace) {
  return static_cast<int>(std::lround(Slider::kSteps * std::log(pace / kSlowest) / std::log(kFastest / kSlowest)));
}

QIcon markerIcon(const std::string& policy, const Theme& t) {
  QPixmap pixmap(32, 32);
  pixmap.setDevicePixelRatio(2);
  pixmap.fill(Qt::transparent);
  QPainter p(&pixmap);
  drawMarker(p, {8, 8}, policyLook(policy, t), true);
  return pixmap;
}

}  // namespace

RunBar::RunBar(Session& session, const RunActions& actions, QWidget* parent)
    : QWidget(parent),
      session_(session),
      actions_(actions) {
  setFixedHeight(48);
  auto* run = new BarButton(actions.run, Icon::Run, BarButton::Look::Main, this);
  buttons_ = {run, new BarButton(actions.step, Icon::Step, BarButton::Look::Quiet, this),
              new BarButton(actions.restart, Icon::Restart, BarButton::Look::Quiet, this)};
  pace_ = new Slider(this);
  pace_->setAccessibleName(tr("Pace"));
  pace_->setToolTip(
      tr("How fast the world runs while turbo is off: %1 to %2 times real time").arg(kSlowest).arg(kFastest));
  pace_->setValue(positionOf(session.pace()));
  connect(pace_, &QSlider::valueChanged, this, [this](int position) { session_.setPace(paceAt(position)); });
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
      session_.setScenario(name);
  });
  task_->setPlaceholderText(tr("Changed model"));
  agent_ = new Combo(tr("Learning rule"), this);
  fillAgents();
  connect(agent_, &QComboBox::activated, this, [this](int i) {
    const QString name = agent_->itemData(i).toString();
    refresh();  // until it is agreed to
    if (name.toStdString() != session_.configuration().names.agent) Q_EMIT agentAsked(name, agent_->itemText(i));
  });
  policy_ = new Combo(tr("Policy"), this);
  for (const auto& entry : session.registry().policies) {
    policy_->addItem(toText(entry.title), toText(entry.name));
    policy_->setItemData(policy_->count() - 1, toText(entry.help), Qt::ToolTipRole);
  }
  connect(policy_, &QComboBox::activated, this,
          [this](int i) { session_.setPolicy(policy_->itemData(i).toString().toStdString()); });

  connect(&session_, &Session::stateChanged, this, [this, run] {
    run->setIcon(session_.running() ? Icon::Pause : Icon::Run);
    refresh();
  });
  connect(&session_, &Session::parametersReplaced, this, [this] {
    fillTasks();
    fillAgents();
    refresh();
  });
  connect(&session_, &Session::configurationChanged, this, &RunBar::refresh);
  for (const auto changed : {&Session::valuesArrived, &Session::lifeReplaced, &Session::stateChanged})
    connect(&session_, changed, this, &RunBar::readNumbers);
  setMarkers();
  refresh();
  readNumbers();
}

/// The counters are drawn from what was read here, and told to a screen reader.
void RunBar::readNumbers() {
  const Numbers& now = session_.numbers();
  texts_ = {toText(countText(static_cast<double>(now.falls))), toText(countText(static_cast<double>(now.episodes))),
            session_.running() ? session_.factorText() : QString()};
  setAccessibleDescription(tr("%1 falls in %2 episodes").arg(texts_.falls, texts_.episodes));
  update();
}

/// The scenarios of the environment, or itself where it has none; then the other environments.
void RunBar::fillTasks() {
  const QSignalBlocker blocker(task_);
  task_->clear();
  const auto add = [&](const auto& entry, const std::string& name, bool isEnvironment) {
    task_->addItem(toText(entry.title), toText(name));
    task_->setItemData(task_->count() - 1, toText(entry.help), Qt::ToolTipRole);
    task_->setItemData(task_->count() - 1, isEnvironment, kIsEnvironment);
  };
  const std::string& here = session_.configuration().names.environment;
  for (const auto& entry : session_.registry().scenarios)
    if (entry.environment == here) add(entry, entry.name, false);
  if (const auto entry = findEntry(session_.registry().environments, "environment", here); entry && task_->count() == 0)
    add(**entry, "", false);
  task_->insertSeparator(task_->count());
  for (const auto& entry : session_.registry().environments)
    if (entry.name != here) add(entry, entry.name, true);
  task_->view()->setMinimumWidth(task_->view()->sizeHintForColumn(0) + 24);
}

void RunBar::fillAgents() {
  const QSignalBlocker blocker(agent_);
  agent_->clear();
  for (const auto& entry : session_.registry().agents) {
    if (entry.name == "scripted" && !session_.task().handMade) continue;  // nothing acts there
    agent_->addItem(toText(entry.title), toText(entry.name));
    agent_->setItemData(agent_->count() - 1, toText(entry.help), Qt::ToolTipRole);
  }
}

void RunBar::setMarkers() {
  const Theme& t = themeOf(*this);
  for (int i = 0; i < policy_->count(); ++i)
    policy_->setItemIcon(i, markerIcon(policy_->itemData(i).toString().toStdString(), t));
}

void RunBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) setMarkers();
}

void RunBar::changePace(int notches) {
  pace_->setValue(pace_->value() + notches * Slider::kSteps / 20);
}

void RunBar::refresh() {
  const Names& names = session_.configuration().names;
  const auto select = [](QComboBox& combo, const std::string& name) {
    const QSignalBlocker blocker(combo);
    combo.setCurrentIndex(combo.findData(toText(name)));
  };
  // A model that was changed by hand is none of the scenarios.
  const auto scenario = findEntry(session_.registry().scenarios, "scenario", names.scenario);
  bool asNamed = true;
  if (scenario)
    for (const auto& [key, value] : (*scenario)->values)
      asNamed &= session_.configuration().parameters.get(key) == value;
  select(*task_, asNamed ? names.scenario : "");
  select(*agent_, names.agent);
  select(*policy_, names.policy);
  if (!pace_->isSliderDown()) {
    const QSignalBlocker blocker(pace_);
    if (paceAt(pace_->value()) != session_.pace()) pace_->setValue(positionOf(session_.pace()));
  }
  update();
}

void RunBar::layOut() {
  int x = 8;
  for (int i = 0; i < 3; ++i, x += 40) buttons_[static_cast<std::size_t>(i)]->move(x, 8);
  x += 64 - 1;
  pace_->setGeometry(x, 12, 106, 24);
  paceLabel_ = x + 112;
  buttons_[3]->move(static_cast<int>(paceLabel_) + 24 + 20, 8);
  factorLabel_ = buttons_[3]->x() + 88;
  x = static_cast<int>(factorLabel_) + 68;
  for (QComboBox* combo : {task_, agent_, policy_}) {
    const int w = combo == task_ ? 148 : combo == policy_ ? 116 : 132;
    combo->setGeometry(x, 8, w, kButton);
    x += w + 8;
  }
}

void RunBar::paintEvent(QPaintEvent*) {
  const Theme& t = themeOf(*this);
  QPainter p(this);
  p.fillRect(rect(), t.panel);
  p.fillRect(QRect(0, height() - 1, width(), 1), t.hairline);
  for (const int x : {buttons_[2]->geometry().right() + 16, static_cast<int>(factorLabel_) + 57})
    p.fillRect(QRect(x, 12, 1, 24), t.hairline);
  p.setFont(textFont(13));
  p.setPen(t.quiet);
  p.drawText(QRectF(pace_->x() - 44, 8, 40, kButton), Qt::AlignVCenter | Qt::AlignRight, tr("Pace"));
  p.setPen(t.ink);
  const double pace = session_.pace();
  p.drawText(QRectF(paceLabel_, 8, 40, kButton), Qt::AlignVCenter,
             QStringLiteral("%1×").arg(pace < 9.95 && pace != 1.0 ? QString::number(pace, 'f', 1)
                                                                  : QString::number(pace, 'f', 0)));
  p.drawText(QRectF(factorLabel_, 8, 64, kButton), Qt::AlignVCenter, texts_.factor);

  // Falls large; from the right: "episodes", its number, "falls", its number.
  double right = width() - 12;
  const auto put = [&](const QString& text, int pixels, int weight, const QColor& colour, double baseline, double gap) {
    p.setFont(textFont(pixels, weight));
    p.setPen(colour);
    const double w = symbolWidth(p.font(), text);
    if (right - w < policy_->geometry().right() + 12) return;
    drawSymbol(p, right - w, baseline, text);
    right -= w + gap;
  };
  put(tr("episodes"), 11, 400, t.quiet, 30, 6);
  put(texts_.episodes, 13, 500, t.ink, 30, 20);
  put(tr("falls"), 11, 400, t.quiet, 30, 7);
  put(texts_.falls, 24, 500, t.fallText, 30, 0);
}

}  // namespace surefoot
