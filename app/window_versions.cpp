// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtGlobal>

#include "app/versions.h"
#include "ui/film/film_writer.h"

namespace surefoot {

std::vector<PartVersion> windowVersions() {
  return {{"Qt", qVersion()}, {"libwebp", webpVersion()}};
}

}  // namespace surefoot
