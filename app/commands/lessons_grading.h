// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot lessons grade`: what students handed in, lived again.
#pragma once

#include "app/commands/commands.h"

namespace surefoot {

int gradeLessons(const Registry& registry, const LessonsRequest& request);

}  // namespace surefoot
