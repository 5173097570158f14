// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C and SIGTERM end a run cleanly: what was done so far is reported. A second one ends the program at once.
#pragma once

#include <atomic>

namespace surefoot {

/// Installs the handlers; the flag they set. It stays for the whole program.
const std::atomic<bool>& watchForInterrupt();

}  // namespace surefoot
