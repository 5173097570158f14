// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C, SIGTERM and SIGHUP end a run cleanly: what was done so far is reported.
#pragma once

#include <atomic>

namespace surefoot {

/// Installs the handlers; the flag they set. They stay for the whole program. A signal that comes a second or more
/// after the first ends the program at once. One that was ignored when the program began stays ignored (nohup; `&` in
/// a script).
const std::atomic<bool>& watchForInterrupt();

/// A write that fails is an error to report (a full disk, a closed pipe), not a signal to die of.
void reportFailedWrites();

}  // namespace surefoot
