// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/knob_rows.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <set>
#include <utility>

#include "core/environment_library.h"
#include "ui/controls/combo.h"
#include "ui/language/from_core.h"
#include "ui/live/form/parameter_row.h"
#include "ui/session/session.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

/// The policy that a parameter belongs to; empty: it is no policy's.
std::string policyOf(const Registry& registry, const std::string& key) {
  for (const PolicyEntry& entry : registry.policies)
    for (const std::string& own : policyKeys(entry))
      if (own == key) return entry.name;
  return {};
}

}  // namespace

KnobRows::KnobRows(Session& session, const std::vector<std::string>& shown, const Ranges& ranges, QWidget* parent)
    : QWidget(parent),
      session_(session),
      ranges_(ranges),
      runs_(std::find(shown.begin(), shown.end(), "run") != shown.end()),
      column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(0, 0, 0, 0);
  whenScaled(this, [this] { column_->setSpacing(scaled(4)); });
  for (const auto& entry : session_.life().configuration().parameters.all()) began_[entry.parameter.key] = entry.value;
  for (const std::string& name : shown) {
    if (session_.life().configuration().parameters.find(name)) addParameter(name);
    if (name == "policy" || name == "agent" || name == "scenario") addChoice(name);
  }
  connect(&session_.life(), &RunningLife::configurationChanged, this, &KnobRows::refresh);
  connect(&session_.life(), &RunningLife::replaced, this, &KnobRows::refresh);
  connect(&session_.editing(), &Editing::needsNewTable, this, [this](const QString& key, double value) {
    if (const Status s = session_.newLives().setParameterAndRestart(key.toStdString(), value); !s)
      Q_EMIT refused(toText(s.error().message));
  });
  constexpr int kSettled = 250;  // [ms] without another turn
  anew_.setSingleShot(true);
  anew_.setInterval(kSettled);
  connect(&anew_, &QTimer::timeout, this, [this] {
    if (session_.life().progress().steps > 0 || session_.life().running()) return;
    if (const Status s = session_.newLives().restart(); !s) Q_EMIT refused(toText(s.error().message));
  });
  refresh();
}

void KnobRows::takeBase() {
  if (std::exchange(hasBase_, true)) return;
  for (const auto& entry : session_.life().configuration().parameters.all()) began_[entry.parameter.key] = entry.value;
  refresh();
}

void KnobRows::addParameter(const std::string& key) {
  Parameter parameter = session_.life().configuration().parameters.find(key)->parameter;
  if (const auto range = ranges_.find(key); range != ranges_.end())
    std::tie(parameter.sliderLow, parameter.sliderHigh) = range->second;
  auto* row = new ParameterRow(parameter, policyOf(session_.life().registry(), key), this);
  connect(row, &ParameterRow::edited, this, &KnobRows::edit);
  connect(row, &ParameterRow::refused, this, &KnobRows::refused);
  column_->addWidget(row);
  rows_.push_back(row);
  ++count_;
}

void KnobRows::addChoice(const std::string& what) {
  const QString name = what == "policy" ? tr("Policy") : what == "agent" ? tr("Learning rule") : tr("Scenario");
  auto* combo = new Combo(name, this);
  const auto add = [combo](const auto& entries) {
    for (const auto& entry : entries) combo->addItem(fromCore(entry.title), toText(entry.name));
  };
  const Registry& registry = session_.life().registry();
  if (what == "policy") add(registry.policies);
  if (what == "scenario")
    for (const AssignmentEntry* entry : scenariosOf(registry, session_.life().configuration().names.environment))
      combo->addItem(fromCore(entry->title), toText(entry->name));
  if (what == "agent")
    for (const AgentEntry& entry : registry.agents)
      if (entry.name != "scripted") combo->addItem(fromCore(entry.title), toText(entry.name));
  if (what == "policy") combo->setPolicyMarkers();
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(name, this));
  row->addStretch(1);
  row->addWidget(combo);
  column_->addLayout(row);
  choices_[what] = combo;
  ++count_;
  connect(combo, &QComboBox::activated, this, [this, what, combo] {
    const std::string chosen = combo->chosen();
    if (what == "policy") return session_.editing().setPolicy(chosen);
    if (what == "scenario") return session_.editing().setScenario(chosen);
    if (chosen == session_.life().configuration().names.agent) return;
    if (const Status s = session_.newLives().setAgent(chosen); !s) Q_EMIT refused(toText(s.error().message));
  });
}

/// Of a life that has not begun, a knob is what it begins with: the same as to turn it and to restart.
void KnobRows::edit(const QString& key, double value) {
  if (runs_ && session_.life().progress().steps == 0 && !session_.life().running()) anew_.start();
  if (const Status s = session_.editing().setParameter(key.toStdString(), value); !s)
    Q_EMIT refused(toText(s.error().message));
  refresh();
}

void KnobRows::refresh() {
  const Configuration& now = session_.life().configuration();
  const auto policy = findEntry(session_.life().registry().policies, "policy", now.names.policy);
  const std::vector<std::string> keys = policy ? policyKeys(**policy) : std::vector<std::string>();
  const std::set<std::string> inForce(keys.begin(), keys.end());
  for (ParameterRow* row : rows_) {
    const auto* entry = now.parameters.find(row->key());
    if (!entry) continue;
    row->show(entry->value, began_[row->key()], session_.life().changedAt(row->key()));
    row->setInForce(inForce.contains(row->key()) ? now.names.policy : "");
  }
  for (const auto& [what, combo] : choices_) {
    const std::string& name = what == "policy"  ? now.names.policy
                              : what == "agent" ? now.names.agent
                                                : now.names.scenario;
    combo->choose(name.empty() ? "actual" : name);
  }
}

}  // namespace surefoot

#include "moc_knob_rows.cpp"
