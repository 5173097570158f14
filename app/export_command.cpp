// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot export`: a store's tables as CSV.
#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "core/laboratory/csv_export.h"

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
