// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot handbook`: the handbook as web pages.
#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/process/resources.h"
#include "app/reports/handbook_language.h"
#include "app/requests/command_help.h"
#include "core/handbook/html.h"

namespace surefoot {

int handbookCommand(const Registry& registry, const HandbookRequest& request) {
  if (request.folder.empty()) return fail({"FOLDER: name the folder to write the handbook to, as `handbook pages`."});
  std::size_t pages = 0;
  const Status written = inLanguage(request.language, [&](const HandbookSpeech& speech) -> Status {
    const auto handbook = makeHandbook(registry, resourceFolder("handbook"), commandHelp(registry), speech);
    if (!handbook) return handbook.error();
    pages = handbook->size();
    return writeHtml(*handbook, resourceFolder("screenshots"), request.folder, speech);
  });
  if (!written) return fail(written.error());
  return print(fmt::format("{}/index.html: {} pages.\n", request.folder, pages));
}

}  // namespace surefoot
