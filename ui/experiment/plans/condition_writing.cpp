// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ConditionForm that writes the block.
#include <fmt/format.h>

#include <QLineEdit>

#include "core/plans/plan_writing.h"
#include "core/text/number_text.h"
#include "ui/controls/combo.h"
#include "ui/experiment/plans/condition_form.h"
#include "ui/language/numbers.h"

namespace surefoot {

namespace {

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

/// The name of the policy, and in braces the varied parameters.
std::string ConditionForm::name() const {
  if (const QString name = name_->text().simplified(); !name.isEmpty()) return name.toStdString();
  const auto policy = findEntry(registry_.policies, "policy", policy_->chosen());  // in every language the same
  std::string name = policy ? (*policy)->title : policy_->chosen();
  if (const std::string on = preLearned_->chosen(); !on.empty()) name = fmt::format("pre({}): {}", on, name);
  for (const Sweep& sweep : sweeps_) {
    const std::string key = sweep.key->chosen();
    if (!key.empty()) name += fmt::format(", {} {{{}}}", key.substr(key.rfind('.') + 1), key);
  }
  return name;
}

Result<std::string> ConditionForm::toml() const {
  const auto c = configure(registry_, names(), {});
  if (!c) return c.error();
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
  const auto lives = length();
  if (!lives) return lives.error();
  toml += *lives;
  if (!sweeps_[0].key->chosen().empty() && sweeps_[0].key->chosen() == sweeps_[1].key->chosen())
    return Error{fmt::format("{}: it is set twice; take it out of one of the two rows.", sweeps_[0].key->chosen())};
  for (const Sweep& sweep : sweeps_) {
    const Parameters::Entry* entry = c->parameters.find(sweep.key->chosen());
    if (!entry) continue;
    const auto values = valuesOf(entry->parameter, typedNumbers(sweep.values->text().trimmed()));
    if (!values) return values.error();
    toml += fmt::format("set.{} = {}\n", entry->parameter.key, *values);
  }
  const auto before = preLearning();
  if (!before) return before.error();
  return toml + *before;
}

Result<std::string> ConditionForm::length() const {
  const char* key = episodes_ ? "episodes" : "minutes";
  const auto length = parseValue({.key = key,
                                  .unit = episodes_ ? "episodes" : "min",
                                  .low = episodes_ ? 1 : 0.001,
                                  .high = 1e6,
                                  .kind = episodes_ ? Kind::Integer : Kind::Real},
                                 typedNumber(length_->text().trimmed()));
  if (!length) return length.error();
  return fmt::format("{} = {}\n", key, *length);
}

Result<std::string> ConditionForm::preLearning() const {
  const std::string on = preLearned_->chosen();
  if (on.empty()) return std::string();
  const auto until =
      parseValue({.key = "pre-learning.until", .low = -1e9, .high = 1e9}, typedNumber(until_->text().trimmed()));
  if (!until) return until.error();
  const auto pool = parseValue({.key = "pre-learning.pool", .low = 1, .high = 1000, .kind = Kind::Integer},
                               pool_->text().trimmed().toStdString());
  if (!pool) return pool.error();
  return fmt::format("pre-learning.scenario = \"{}\"\npre-learning.until = {}\npre-learning.pool = {:.0f}\n", on,
                     *until, *pool);
}

}  // namespace surefoot
