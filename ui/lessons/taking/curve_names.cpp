// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/taking/curve_names.h"

#include <algorithm>

#include "core/environment_library.h"
#include "ui/language/from_core.h"
#include "ui/lessons/driver/lesson_driver.h"
#include "ui/running/run_names.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

namespace {

constexpr qsizetype kMostWords = 2;

template <class Entries>
QString titleOf(const Entries& entries, const std::string& kind, const std::string& name) {
  const auto entry = findEntry(entries, kind, name);
  return entry ? fromCore((*entry)->title) : toText(name);
}

}  // namespace

CurveNames::CurveNames(LessonDriver& driver) : driver_(driver) {
  const Names& start = driver.lesson().start.names;
  const auto look = [&](const LessonActions& actions) {
    for (const LessonAction& a : actions) {
      rules_ = rules_ || (a.kind == LessonAction::Kind::Agent && a.value != start.agent);
      policies_ = policies_ || (a.kind == LessonAction::Kind::Policy && a.value != start.policy);
      const bool known = std::find(changed_.begin(), changed_.end(), a.key) != changed_.end();
      if (a.kind == LessonAction::Kind::Set && !known) changed_.push_back(a.key);
    }
  };
  for (const LessonStep& step : driver.lesson().steps) {
    look(step.begin);
    if (step.predict) look(step.predict->then);
    const auto shows = [&](const char* name) { return std::find(step.show.begin(), step.show.end(), name); };
    rules_ = rules_ || shows("agent") != step.show.end();
    policies_ = policies_ || shows("policy") != step.show.end();
  }
}

QString CurveNames::of(const RunCurve& curve) const {
  const RunningLife& life = driver_.session().life();
  const auto found = names_.find(curve.number);
  QStringList words = found == names_.end() ? QStringList() : found->second.words;
  if (policies_) {
    const std::string lived = policiesOf(curve, life.registry());
    const std::string& now = life.configuration().names.policy;
    words.prepend(lived.empty() ? titleOf(life.registry().policies, "policy", now) : toText(lived));
  }
  if (!words.isEmpty()) return words.mid(0, kMostWords).join(QStringLiteral(", "));
  return life.curves().earlier().empty() ? QString() : curve.began.empty() ? tr("from nothing") : tr("learned before");
}

void CurveNames::note() {
  const RunningLife& life = driver_.session().life();
  const int number = life.curves().live().number;
  const auto named = names_.find(number);
  if (named != names_.end() && life.progress().episodes > 0 && named->second.step != driver_.number()) return;
  names_[number] = {words(), driver_.number()};
}

QStringList CurveNames::words() const {
  const RunningLife& life = driver_.session().life();
  const Configuration &began = life.began(), &now = life.configuration();
  const Registry& registry = life.registry();
  const auto policy = findEntry(registry.policies, "policy", now.names.policy);
  const std::vector<std::string> own = policy ? policyKeys(**policy) : std::vector<std::string>();
  QStringList words;
  if (!now.names.scenario.empty() && now.names.scenario != "actual")
    if (const auto entry = findScenario(registry, now.names.environment, now.names.scenario))
      words << fromCore((*entry)->title);
  if (rules_) words << titleOf(registry.agents, "agent", now.names.agent);
  // The knobs of the step first, then what the lesson turns by itself.
  const LessonStep& step = driver_.step();
  std::vector<std::string> keys = step.show;
  keys.insert(keys.end(), changed_.begin(), changed_.end());
  std::set<std::string> told;
  for (const std::string& key : keys) {
    const auto *entry = now.parameters.find(key), *before = began.parameters.find(key);
    const bool unused = key.starts_with("policy.") && std::find(own.begin(), own.end(), key) == own.end();
    if (!entry || unused || !told.insert(key).second) continue;
    // A symbol is known from its knob.
    const bool known = std::find(step.show.begin(), step.show.end(), key) != step.show.end();
    const std::string symbol = known || key.starts_with("policy.") ? entry->parameter.symbol : std::string();
    QString value = valueText(entry->parameter, entry->value);
    // A knob that was turned at rest says nothing of what was lived before.
    const std::int64_t steps = life.progress().steps, changed = life.changedAt(key).value_or(steps);
    if (before && before->value != entry->value && steps > 0 && changed > 0) {
      const QString old = valueText(before->parameter, before->value);
      value = changed < steps ? old + QStringLiteral(" → ") + value : old;
    }
    words << QStringLiteral("%1 %2").arg(fromCore(symbol.empty() ? entry->parameter.title : symbol), value);
  }
  return words;
}

}  // namespace surefoot
