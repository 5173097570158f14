// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/task_words.h"

#include "ui/language/from_core.h"
#include "ui/language/numbers.h"
#include "ui/style/symbol_text.h"

namespace surefoot {

QString symbolOf(const StateVariable& v) {
  return fromCore(v.symbol.empty() ? v.title : v.symbol);
}

QString axisTitleOf(const StateVariable& v) {
  const QString name = v.symbol.empty() ? fromCore(v.title) : fromCore(v.title) + ' ' + toText(v.symbol);
  return v.unit.empty() ? name : QStringLiteral("%1 [%2]").arg(name, toText(v.unit));
}

QString actionNameOf(const Task& task, std::size_t action) {
  if (!task.actionVariables.empty()) {
    QStringList levels;
    for (std::size_t j = 0; j < task.actionVariables.size(); ++j)
      levels << fixedNumber(task.actionVariables[j].levels[levelOf(task, action, j)], 1);
    return levels.join(QStringLiteral(" / "));
  }
  return action < task.actionNames.size() ? fromCore(task.actionNames[action]) : fixedNumber(task.actions[action], 2);
}

}  // namespace surefoot
