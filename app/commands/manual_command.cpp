// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the manual pages; run when a package is made.
#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.h"
#include "app/manual/man_pages.h"
#include "core/files/whole_file.h"
#include "core/text/printable.h"

namespace surefoot {

int manualCommand(const Registry& registry, const ManualRequest& request) {
  if (request.folder.empty() || request.date.empty())
    return fail({"manual: a folder and a date are needed, as in `surefoot manual pages 2026-11-30`."});
  std::vector<ManualFile> files = commandPages(registry, request.date);
  files.push_back(parametersPage(registry, request.date));
  const std::filesystem::path folder = request.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    return fail({fmt::format("{}: the folder cannot be made: {}.", printable(request.folder), error.message()),
                 ErrorKind::File});
  for (const ManualFile& file : files)
    if (const Status s = writeWhole("manual page", (folder / file.name).string(), file.text); !s)
      return fail(s.error());
  return kDone;
}

}  // namespace surefoot
