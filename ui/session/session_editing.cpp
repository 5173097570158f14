// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Session that changes the life that runs: parameters, policy, learning rule, scenario.
#include <chrono>

#include "ui/session/session.h"

namespace surefoot {

namespace {

/// One parameter, changed by hand. Changes of one that follow each other are one.
class Edit final : public QUndoCommand {
 public:
  using Apply = std::function<bool(const std::string&, double, bool redo)>;  // false: it was of another life
  Edit(Apply apply, const Parameter& parameter, double before, double after)
      : QUndoCommand(QString::fromStdString(parameter.title)),
        apply_(std::move(apply)),
        key_(parameter.key),
        before_(before),
        after_(after) {}
  void undo() override { setObsolete(!apply_(key_, before_, false)); }
  void redo() override {
    if (done_) setObsolete(!apply_(key_, after_, true));
    done_ = true;  // the first time it was done already
  }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const Edit&>(*other);
    if (next.key_ != key_ || next.when_ - when_ > std::chrono::seconds(1)) return false;
    after_ = next.after_;
    when_ = next.when_;
    return true;
  }

 private:
  Apply apply_;
  std::string key_;
  double before_, after_;
  bool done_ = false;
  std::chrono::steady_clock::time_point when_ = std::chrono::steady_clock::now();
};

/// Curves of earlier lives that were taken out of the charts.
class RemovedRuns final : public QUndoCommand {
 public:
  RemovedRuns(RunCurves& curves, std::vector<int> numbers, std::function<void()> changed)
      : QUndoCommand(QObject::tr("Remove earlier runs")),
        curves_(curves),
        numbers_(std::move(numbers)),
        changed_(std::move(changed)) {}
  void undo() override {
    curves_.putBack(removed_);
    changed_();
  }
  void redo() override {
    removed_ = curves_.remove(numbers_);
    changed_();
  }

 private:
  RunCurves& curves_;
  std::vector<int> numbers_;
  std::function<void()> changed_;
  std::vector<RunCurve> removed_;
};

}  // namespace

void Session::removeEarlierRuns(std::vector<int> numbers) {
  if (!numbers.empty()) push(new RemovedRuns(curves_, std::move(numbers), [this] { Q_EMIT curvesChanged(); }));
}

Status Session::setParameter(const std::string& key, double value) {
  const Parameters::Entry* found = configuration_.parameters.find(key);
  if (!found) return apply(key, value);  // which says so
  const Parameters::Entry before = *found;
  const Status s = apply(key, value);
  if (s && before.parameter.when != When::NewTable && before.value != value)
    push(new Edit(
        [this, of = lineage_](const std::string& k, double v, bool redo) {
          if (of != lineage_) return undoOnceMore(redo), false;
          static_cast<void>(static_cast<bool>(apply(k, v)));
          return true;
        },
        before.parameter, before.value, value));
  return s;
}

Status Session::apply(const std::string& key, double value) {
  Configuration changed = configuration_;
  if (const Status s = changed.parameters.set(key, value); !s) return s;
  const Parameters::Entry* entry = configuration_.parameters.find(key);
  if (entry->value == value) return Done{};
  if (entry->parameter.when == When::NewTable) {
    Q_EMIT needsNewTable(QString::fromStdString(key), value);
    return Done{};
  }
  if (const auto environment = makeEnvironment(registry_, changed); !environment) return environment.error();
  configuration_ = std::move(changed);
  learner_->send(SetParameter{key, value});
  configuration_.parameters.applyTo(viewer_->policy(), "policy.");
  if (key.starts_with("environment.")) makeViewer();
  Q_EMIT configurationChanged();
  return Done{};
}

Status Session::setParameterAndRestart(const std::string& key, double value) {
  Configuration changed = configuration_;
  if (const Status s = changed.parameters.set(key, value); !s) return s;
  return beginAgain(std::move(changed));
}

void Session::setPolicy(const std::string& name) {
  auto forLearner = makePolicy(registry_, name, configuration_.parameters);
  auto forViewer = makePolicy(registry_, name, configuration_.parameters);
  if (!forLearner || !forViewer) return;
  configuration_.names.policy = name;
  learner_->send(SetPolicy{name, std::move(*forLearner)});
  viewer_->setPolicy(std::move(*forViewer));
  Q_EMIT configurationChanged();
}

Result<Configuration> Session::configurationUnder(const Names& names) const {
  auto changed = configure(registry_, names, {});
  if (!changed) return changed;
  for (const auto& entry : configuration_.parameters.all())
    if (changed->parameters.find(entry.parameter.key))
      if (const Status s = changed->parameters.set(entry.parameter.key, entry.value); !s) return s.error();
  changed->seed = configuration_.seed;
  changed->minutes = configuration_.minutes;
  changed->episodes = configuration_.episodes;
  return changed;
}

Status Session::setAgent(const std::string& name) {
  if (name == configuration_.names.agent) return Done{};
  Names names = configuration_.names;
  names.agent = name;
  auto changed = configurationUnder(names);
  return changed ? begin(std::move(*changed)) : Status(changed.error());
}

void Session::setScenario(const std::string& name) {
  const auto entry = findEntry(registry_.scenarios, "scenario", name);
  if (!entry) return;
  configuration_.names.scenario = name;
  base_ = baseOf(configuration_.names);
  beginMacro(QString::fromStdString((*entry)->title));
  for (const auto& [key, value] : (*entry)->values)
    if (!setParameter(key, value)) break;
  endMacro();
  Q_EMIT configurationChanged();
}

}  // namespace surefoot
