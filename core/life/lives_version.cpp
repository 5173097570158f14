// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/lives_version.h"

#include <fmt/format.h>

#include "core/basics/version.h"
#include "core/files/read_file.h"
#include "core/text/text.h"

namespace surefoot {

Error otherLives(const std::string& file, int version, const std::string& program) {
  const std::string which = program.empty() ? "another version of Surefoot" : fmt::format("Surefoot {}", program);
  const std::string lives = version == kLivesVersionUnknown ? "which did not note its lives"
                                                            : fmt::format("whose lives are number {}", version);
  return fileError(file, fmt::format("it was lived by {}, {}; those of this one ({}) are number {}, and may take "
                                     "another course.",
                                     shortened(which), lives, kVersion, kLivesVersion));
}

}  // namespace surefoot
