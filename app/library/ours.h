// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to choose from in this process. Any thread.
#pragma once

#include "core/registry.h"

namespace surefoot {

/// Made by the first call; it lives as long as the process. An error: Box2D cannot be made to give the same bits
/// everywhere, and nothing must be lived.
Result<const Registry*> ourRegistry();

}  // namespace surefoot
