// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/plans/condition_form.h"

#include <fmt/format.h>

#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "core/environment_library.h"
#include "core/experiment/configuration.h"
#include "ui/controls/combo.h"
#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

template <class Entries>
void fill(Combo* combo, const Entries& entries) {
  for (const auto& entry : entries) combo->addItem(fromCore(entry.title), toText(entry.name));
}

/// The box takes the width that is free, even if its longest entry is wider.
void narrow(Combo* combo) {
  combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  combo->setMinimumContentsLength(8);
  combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QLineEdit* field(const QString& name, const QString& text) {
  auto* edit = new QLineEdit(text);
  edit->setAccessibleName(name);
  return edit;
}

}  // namespace

ConditionForm::ConditionForm(const Registry& registry, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      lengthLabel_(new QLabel),
      name_(field(tr("Name of the condition"), {})),
      length_(field(tr("Length of a life"), {})),
      until_(field(tr("Average reward that ends the pre-learning"), "198")),
      pool_(field(tr("Q-functions in the pool"), "5")),
      environment_(new Combo(tr("Environment of the condition"))),
      scenario_(new Combo(tr("Scenario of the condition"))),
      agent_(new Combo(tr("Learning rule of the condition"))),
      features_(new Combo(tr("Representation of the condition"))),
      policy_(new Combo(tr("Policy of the condition"))),
      preLearned_(new Combo(tr("Pre-learning of the condition"))) {
  fill(environment_, registry.environments);
  fill(agent_, registry.agents);
  fill(features_, registry.features);
  fill(policy_, registry.policies);
  environment_->choose(Names().environment);
  agent_->choose(Names().agent);
  features_->choose(Names().features);
  policy_->choose(Names().policy);
  for (Combo* combo : {environment_, scenario_, agent_, features_, policy_, preLearned_}) narrow(combo);
  auto* form = new QFormLayout(this);
  whenScaled(this, [form] {
    form->setContentsMargins(scaled({12, 4, 12, 12}));
    form->setVerticalSpacing(scaled(6));
    form->setHorizontalSpacing(scaled(10));
  });
  form->addRow(tr("Environment"), environment_);
  form->addRow(tr("Scenario"), scenario_);
  form->addRow(tr("Learning rule"), agent_);
  form->addRow(tr("Representation"), features_);
  form->addRow(tr("Policy"), policy_);
  form->addRow(lengthLabel_, length_);
  int number = 0;
  for (Sweep& sweep : sweeps_) {
    ++number;
    sweep = {new Combo(tr("Parameter %1 to set").arg(number)), field(tr("Values of parameter %1").arg(number), {})};
    sweep.values->setPlaceholderText(tr("one, or several: 0; 50; 100"));
    narrow(sweep.key);
    form->addRow(number == 1 ? tr("Set or vary") : tr("and"), sweep.key);
    form->addRow({}, sweep.values);
  }
  makePreLearning(form);
  name_->setPlaceholderText(tr("made from policy and values"));
  form->addRow(tr("Name"), name_);
  watch();
  setCounted(!hasClock());
  fillForEnvironment();
}

void ConditionForm::watch() {
  connect(environment_, &QComboBox::activated, this, [this] {
    features_->choose(Names().features);  // these features suit every environment
    if (episodes_ == hasClock()) setCounted(!hasClock());
    fillForEnvironment();
  });
  for (Combo* combo : {agent_, features_, policy_})
    connect(combo, &QComboBox::activated, this, &ConditionForm::fillKeys);
  const auto touch = [this] { touched_ = true; };
  for (Combo* combo : findChildren<Combo*>()) connect(combo, &QComboBox::activated, this, touch);
  for (QLineEdit* edit : findChildren<QLineEdit*>()) connect(edit, &QLineEdit::textEdited, this, touch);
}

void ConditionForm::beginAs(const Condition& condition) {
  if (touched_) return;
  const Configuration& c = condition.configuration;
  environment_->choose(c.names.environment);
  agent_->choose(c.names.agent);
  features_->choose(c.names.features);
  policy_->choose(c.names.policy);
  setCounted(c.episodes && (!c.minutes || !hasClock()));
  if (episodes_)
    length_->setText(QString::number(*c.episodes));
  else if (c.minutes)
    length_->setText(localNumbers(fmt::format("{}", *c.minutes)));
  fillForEnvironment();
  scenario_->choose(c.names.scenario);
  if (!condition.preLearning) return;
  preLearned_->choose(condition.preLearning->configuration.names.scenario);
  if (const auto& until = condition.preLearning->configuration.until)
    until_->setText(localNumbers(fmt::format("{}", *until)));
  pool_->setText(QString::number(condition.preLearning->pool));
}

/// Sets the unit of a life's length (episodes or minutes), with a usual length.
void ConditionForm::setCounted(bool episodes) {
  episodes_ = episodes;
  lengthLabel_->setText(episodes ? tr("A life [episodes]") : tr("A life [min]"));
  length_->setText(episodes ? "500" : "6");
}

bool ConditionForm::hasClock() const {
  const auto c = configure(registry_, names(), {});
  if (!c) return false;
  const auto environment = makeEnvironment(registry_, *c);
  return environment && (*environment)->task().stepTime;
}

void ConditionForm::makePreLearning(QFormLayout* form) {
  form->addRow(tr("Pre-learned on"), preLearned_);
  form->addRow(tr("until reward"), until_);
  form->addRow(tr("Q-functions"), pool_);
  const auto enable = [this] {
    for (QLineEdit* edit : {until_, pool_}) edit->setEnabled(!preLearned_->chosen().empty());
  };
  connect(preLearned_, &QComboBox::currentIndexChanged, this, enable);
  enable();
}

void ConditionForm::fillForEnvironment() {
  scenario_->clear();
  preLearned_->clear();
  preLearned_->addItem(tr("nothing"));
  for (const AssignmentEntry* entry : scenariosOf(registry_, environment_->chosen())) {
    scenario_->addItem(fromCore(entry->title), toText(entry->name));
    preLearned_->addItem(fromCore(entry->title), toText(entry->name));
  }
  scenario_->setEnabled(scenario_->count() > 0);
  preLearned_->setEnabled(preLearned_->count() > 1);
  fillKeys();
}

Names ConditionForm::names() const {
  Names n;
  n.environment = environment_->chosen();
  n.scenario = scenario_->chosen();
  n.agent = agent_->chosen();
  n.features = features_->chosen();
  n.policy = policy_->chosen();
  return n;
}

void ConditionForm::fillKeys() {
  const auto c = configure(registry_, names(), {});
  if (!c) return;
  const auto policies = findEntry(registry_.policies, "policy", names().policy);
  const std::vector<std::string> own = policies ? policyKeys(**policies) : std::vector<std::string>{};
  for (Sweep& sweep : sweeps_) {
    const std::string before = sweep.key->chosen();
    sweep.key->clear();
    sweep.key->addItem(tr("nothing"));
    for (const auto& entry : c->parameters.all()) {
      const std::string& key = entry.parameter.key;
      if (key.starts_with("policy.") && std::find(own.begin(), own.end(), key) == own.end()) continue;
      sweep.key->addItem(QStringLiteral("%1 (%2)").arg(fromCore(entry.parameter.title), toText(key)), toText(key));
    }
    sweep.key->choose(before);
  }
}

}  // namespace surefoot

#include "moc_condition_form.cpp"
