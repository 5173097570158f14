// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/editing.h"

#include <chrono>

#include "core/environment_library.h"
#include "core/saved/q_file.h"
#include "ui/language/from_core.h"

namespace surefoot {

namespace {

/// A change of one parameter by hand. Changes of the same parameter within a second are joined into one.
class Edit final : public QUndoCommand {
 public:
  Edit(RunningLife& life, History& history, const Parameter& parameter, double before, double after)
      : QUndoCommand(fromCore(parameter.title)),
        life_(life),
        history_(history),
        of_(life.lineage()),
        key_(parameter.key),
        before_(before),
        after_(after) {}
  void undo() override { apply(before_, false); }
  void redo() override {
    if (done_) apply(after_, true);
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
  void apply(double value, bool redo) {
    setObsolete(of_ != life_.lineage());
    if (isObsolete()) return history_.undoOnceMore(redo);
    static_cast<void>(static_cast<bool>(life_.setParameter(key_, value)));
  }

  RunningLife& life_;
  History& history_;
  std::uint64_t of_;
  std::string key_;
  double before_, after_;
  bool done_ = false;
  std::chrono::steady_clock::time_point when_ = std::chrono::steady_clock::now();
};

}  // namespace

Status Editing::setParameter(const std::string& key, double value) {
  Parameters checked = life_.configuration().parameters;
  const Parameters::Entry* found = checked.find(key);
  const std::optional<double> before = found ? std::optional(found->value) : std::nullopt;
  if (const Status s = checked.set(key, value); !s) return s;
  const Parameters::Entry now = *checked.find(key);
  if (now.value == before) return Done{};
  if (now.parameter.when == When::NewTable) {
    Q_EMIT needsNewTable(QString::fromStdString(key), value);
    return Done{};
  }
  if (const Status s = life_.setParameter(key, value); !s) return s;
  history_.push(new Edit(life_, history_, now.parameter, *before, value));
  return Done{};
}

void Editing::setPolicy(const std::string& name) {
  static_cast<void>(static_cast<bool>(life_.setPolicy(name)));  // the list holds only policies that can be made
}

Status Editing::guardBy(const std::string& path) {
  auto file = readQFile(path);
  if (!file) return file.error();
  if (const Status s = life_.setTeacher(std::move(*file)); !s) return s;
  return setParameter("policy.guardian", static_cast<double>(GuardedBy::QFunction));
}

void Editing::setScenario(const std::string& name) {
  const auto entry = findScenario(life_.registry(), life_.configuration().names.environment, name);
  if (!entry) return;
  history_.beginMacro(fromCore((*entry)->title));
  for (const auto& [key, value] : (*entry)->values)
    if (!setParameter(key, value)) break;
  history_.endMacro();
  life_.setScenario(name);
}

}  // namespace surefoot

#include "moc_editing.cpp"
