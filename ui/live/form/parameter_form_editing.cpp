// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ParameterForm that changes parameters.
#include "ui/live/form/parameter_form.h"
#include "ui/live/form/parameter_row.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/session/history.h"
#include "ui/style/theme.h"
#include "ui/support/ask_for_file.h"

namespace surefoot {

void ParameterForm::edit(const QString& key, double value) {
  const bool teacher = key == "policy.guardian" && static_cast<GuardedBy>(value) == GuardedBy::QFunction;
  if (teacher && !life_.configuration().teacher)
    askForTeacher();
  else
    tell(key, editing_.setParameter(key.toStdString(), value));
  refresh();
}

/// Why a value was refused, if it was.
void ParameterForm::tell(const QString& key, const Status& status) {
  if (status) return;
  const QString sentence = toText(status.error().message);
  for (const Section& section : sections_)
    for (const Row& row : section.rows)
      if (row.row && toText(row.row->key()) == key) row.row->tellRefused(tr("not with the others"), sentence);
  Q_EMIT refused(sentence);
}

/// The Q-function that is to act as guardian.
void ParameterForm::askForTeacher() {
  askForFile(this, tr("The guardian's Q-function"), tr("Q-functions (*.safetensors *.surefoot);;All files (*)"),
             [this](const QString& path) {
               tell("policy.guardian", editing_.guardBy(path.toStdString()));
               refresh();
             });
}

void ParameterForm::resetAll() {
  const Parameters before = life_.configuration().parameters;
  history_.beginMacro(tr("all parameters"));
  for (const auto& entry : before.all())
    if (entry.parameter.when != When::NewTable) edit(toText(entry.parameter.key), life_.base(entry.parameter.key));
  history_.endMacro();
}

}  // namespace surefoot
