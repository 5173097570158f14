// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot handbook`: the handbook as web pages.
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/process/resources.h"
#include "app/requests/command_help.h"
#include "core/handbook/html.h"

namespace surefoot {

int handbookCommand(const Registry& registry, const HandbookRequest& request) {
  if (request.folder.empty()) return fail({"FOLDER: name the folder to write the handbook to, as `handbook pages`."});
  const auto handbook = makeHandbook(registry, resourceFolder("handbook"), commandHelp(registry));
  if (!handbook) return fail(handbook.error());
  if (const Status s = writeHtml(*handbook, resourceFolder("screenshots"), request.folder); !s) return fail(s.error());
  return print(fmt::format("{}/index.html: {} pages.\n", request.folder, handbook->size()));
}

}  // namespace surefoot
