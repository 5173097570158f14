// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot export`: a store's tables as CSV.
#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "core/store/csv_export.h"

namespace surefoot {

int exportCommand(const ExportRequest& request) {
  if (request.store.empty()) return fail({"STORE: the store of results is needed."});
  if (!request.csv) return fail({"--csv: the folder to write to is needed."});
  const auto store = Store::open(request.store, &watchForInterrupt());
  if (!store) return fail(store.error());
  const Status written = exportCsv(*store, *request.csv, "--csv", request.forSpreadsheets);
  if (!written) return fail(written.error());
  tellNote(*store);
  return kDone;
}

}  // namespace surefoot
