// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot window` in a build without Qt.
#include "app/commands/commands.h"
#include "app/versions.h"

namespace surefoot {

int windowCommand(const Registry&, const WindowRequest&, int, char**) {
  return fail({"this build has no window (SUREFOOT_UI=OFF); `surefoot train --minutes 9` learns without one."});
}

std::vector<PartVersion> windowVersions() {
  return {};
}

}  // namespace surefoot
