// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.h"
#include "app/process/interrupt.h"
#include "core/basics/typed_json.h"
#include "core/findings/findings.h"

namespace surefoot {

int statisticsCommand(const Registry& registry, const StatisticsRequest& request) {
  if (request.store.empty()) return fail({"STORE: the store of results is needed."});
  const auto store = Store::open(request.store, &watchForInterrupt());
  if (!store) return fail(store.error());
  const auto findings = findingsOf(registry, *store);
  if (!findings) return fail(findings.error());
  tellNote(*store);
  if (request.csv) return print(findingsAsCsv(*findings));
  if (request.latex) return print(findingsAsLatex(*findings));
  return print(request.json ? jsonText(findingsAsJson(*findings), 2) + "\n" : findingsAsTable(*findings));
}

}  // namespace surefoot
