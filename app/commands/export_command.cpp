// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot export`: a store's tables as CSV, or the policy of a Q-function as C.
#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "core/store/csv_export.h"

namespace surefoot {

int exportCommand(const Registry& registry, const ExportRequest& request) {
  if (request.file.empty()) return fail({"FILE: a store of results is needed, or a Q-function."});
  if (request.csv && request.c) return fail({"--c: it goes with a Q-function, and --csv with a store of results."});
  if (!request.c && (request.floats || request.selfTest))
    return fail({std::string(request.floats ? "--float" : "--self-test") + ": it goes with --c FILE."});
  if (request.c) return exportPolicy(registry, request);
  if (!request.csv) return fail({"--csv: the folder to write a store's tables to is needed; or --c for a policy."});
  const auto store = Store::open(request.file, &watchForInterrupt());
  if (!store) return fail(store.error());
  const Status written = exportCsv(*store, *request.csv, "--csv", request.forSpreadsheets);
  if (!written) return fail(written.error());
  tellNote(*store);
  return kDone;
}

}  // namespace surefoot
