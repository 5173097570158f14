// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiment/plans/condition_form.h"

#include <fmt/format.h>

#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include "core/plans/plan_writing.h"
#include "core/text/number_text.h"
#include "core/text/text.h"
#include "ui/controls/combo.h"
#include "ui/style/scale.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

std::string chosen(const Combo* combo) {
  return combo->currentData().toString().toStdString();
}

template <class Entries>
void fill(Combo* combo, const Entries& entries) {
  for (const auto& entry : entries) combo->addItem(toText(entry.title), toText(entry.name));
}

/// As wide as there is room, whatever its longest entry is.
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

/// "0; 50; 100" as numbers or choices of a parameter: 0 or [0, 50, 100].
Result<std::string> valuesOf(const Parameter& parameter, const std::string& text) {
  auto list = splitList(parameter.key, text);
  const bool one = text.find_first_of(",;") == std::string::npos && parseValue(parameter, text);  // "9 min"
  if (one) list = std::vector<std::string>{text};
  if (!list) return list.error();
  std::vector<std::string> values;
  for (const std::string& item : *list) {
    const auto value = parseValue(parameter, item);
    if (!value) return value.error();
    const std::string written = formatValue(parameter, *value);
    values.push_back(parameter.choices.empty() ? written : tomlText(written));
  }
  return values.size() == 1 ? values[0] : fmt::format("[{}]", fmt::join(values, ", "));
}

}  // namespace

ConditionForm::ConditionForm(const Registry& registry, QWidget* parent)
    : QWidget(parent),
      registry_(registry),
      name_(field(tr("Name of the condition"), {})),
      minutes_(field(tr("Length of a life"), "6")),
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
  environment_->setCurrentIndex(environment_->findData(toText(Names().environment)));
  agent_->setCurrentIndex(agent_->findData(toText(Names().agent)));
  features_->setCurrentIndex(features_->findData(toText(Names().features)));
  policy_->setCurrentIndex(policy_->findData(toText(Names().policy)));
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
  form->addRow(tr("A life [min, or episodes]"), minutes_);
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
  auto* add = new QPushButton(tr("Add the condition"));
  form->addRow({}, add);
  connect(add, &QPushButton::clicked, this, &ConditionForm::addAsked);
  connect(environment_, &QComboBox::activated, this, &ConditionForm::fillForEnvironment);
  for (Combo* combo : {agent_, features_, policy_})
    connect(combo, &QComboBox::activated, this, &ConditionForm::fillKeys);
  fillForEnvironment();
}

void ConditionForm::makePreLearning(QFormLayout* form) {
  form->addRow(tr("Pre-learned on"), preLearned_);
  form->addRow(tr("until reward"), until_);
  form->addRow(tr("Q-functions"), pool_);
  const auto enable = [this] {
    for (QLineEdit* edit : {until_, pool_}) edit->setEnabled(!chosen(preLearned_).empty());
  };
  connect(preLearned_, &QComboBox::currentIndexChanged, this, enable);
  enable();
}

void ConditionForm::fillForEnvironment() {
  scenario_->clear();
  preLearned_->clear();
  preLearned_->addItem(tr("nothing"));
  for (const auto& entry : registry_.scenarios) {
    if (entry.environment != chosen(environment_)) continue;
    scenario_->addItem(toText(entry.title), toText(entry.name));
    preLearned_->addItem(toText(entry.title), toText(entry.name));
  }
  scenario_->setEnabled(scenario_->count() > 0);
  preLearned_->setEnabled(preLearned_->count() > 1);
  fillKeys();
}

Names ConditionForm::names() const {
  Names n;
  n.environment = chosen(environment_);
  n.scenario = chosen(scenario_);
  n.agent = chosen(agent_);
  n.features = chosen(features_);
  n.policy = chosen(policy_);
  return n;
}

void ConditionForm::fillKeys() {
  const auto c = configure(registry_, names(), {});
  if (!c) return;
  const auto policies = findEntry(registry_.policies, "policy", names().policy);
  const std::vector<std::string> own = policies ? policyKeys(**policies) : std::vector<std::string>{};
  for (Sweep& sweep : sweeps_) {
    const std::string before = chosen(sweep.key);
    sweep.key->clear();
    sweep.key->addItem(tr("nothing"));
    for (const auto& entry : c->parameters.all()) {
      const std::string& key = entry.parameter.key;
      if (key.starts_with("policy.") && std::find(own.begin(), own.end(), key) == own.end()) continue;
      sweep.key->addItem(toText(fmt::format("{} ({})", entry.parameter.title, key)), toText(key));
    }
    sweep.key->setCurrentIndex(std::max(0, sweep.key->findData(toText(before))));
  }
}

/// Its policy, and in braces what is varied.
std::string ConditionForm::name() const {
  if (const QString name = name_->text().simplified(); !name.isEmpty()) return name.toStdString();
  std::string name = policy_->currentText().toStdString();
  if (const std::string on = chosen(preLearned_); !on.empty()) name = fmt::format("pre({}): {}", on, name);
  for (const Sweep& sweep : sweeps_) {
    const std::string key = chosen(sweep.key);
    if (!key.empty()) name += fmt::format(", {} {{{}}}", key.substr(key.rfind('.') + 1), key);
  }
  return name;
}

Result<std::string> ConditionForm::toml() const {
  const auto c = configure(registry_, names(), {});
  if (!c) return c.error();
  const auto environment = makeEnvironment(registry_, *c);
  if (!environment) return environment.error();
  std::string toml = fmt::format("[[condition]]\nname = {}\nbase = false\n", tomlText(name()));
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) toml += fmt::format("{} = \"{}\"\n", key, value);
  };
  const Names n = names();
  line("environment", n.environment);
  line("scenario", n.scenario);
  line("agent", n.agent);
  line("features", n.features);
  line("policy", n.policy);
  const bool clock = (*environment)->task().stepTime.has_value();
  const auto length = parseValue({.key = clock ? "minutes" : "episodes",
                                  .unit = clock ? "min" : "episodes",
                                  .low = clock ? 0.001 : 1,
                                  .high = 1e6,
                                  .kind = clock ? Kind::Real : Kind::Integer},
                                 minutes_->text().trimmed().toStdString());
  if (!length) return length.error();
  toml += clock ? fmt::format("minutes = {}\n", *length) : fmt::format("episodes = {:.0f}\n", *length);
  if (!chosen(sweeps_[0].key).empty() && chosen(sweeps_[0].key) == chosen(sweeps_[1].key))
    return Error{fmt::format("{}: it is set twice; take it out of one of the two rows.", chosen(sweeps_[0].key))};
  for (const Sweep& sweep : sweeps_) {
    const Parameters::Entry* entry = c->parameters.find(chosen(sweep.key));
    if (!entry) continue;
    const auto values = valuesOf(entry->parameter, sweep.values->text().trimmed().toStdString());
    if (!values) return values.error();
    toml += fmt::format("set.{} = {}\n", entry->parameter.key, *values);
  }
  if (const std::string on = chosen(preLearned_); !on.empty()) {
    const auto until =
        parseValue({.key = "pre-learning.until", .low = -1e9, .high = 1e9}, until_->text().trimmed().toStdString());
    if (!until) return until.error();
    const auto pool = parseValue({.key = "pre-learning.pool", .low = 1, .high = 1000, .kind = Kind::Integer},
                                 pool_->text().trimmed().toStdString());
    if (!pool) return pool.error();
    toml += fmt::format("pre-learning.scenario = \"{}\"\npre-learning.until = {}\npre-learning.pool = {:.0f}\n", on,
                        *until, *pool);
  }
  return toml;
}

}  // namespace surefoot
