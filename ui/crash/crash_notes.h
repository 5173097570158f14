// SPDX-License-Identifier: GPL-3.0-or-later
// What a report of a crash will say, kept ready while all is well: a signal handler may not allocate, lock or format
// (signal-safety(7)), it can only write what is there. The report is a file on this computer, and nothing sends it.
// Notes are taken on the window's thread; a crash may be on any.
#pragma once

#include <string>
#include <string_view>

namespace surefoot {

/// From now on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT leave a report in `file`, which is made only then, and end
/// the program as they would have. `about`: lines on the program and the computer. Once, before the window.
void watchForCrashes(const std::string& file, const std::string& about);

/// A command that a person gave, by its name; the last thirty are kept. What a person typed and names of files do not
/// belong here.
void noteCommand(std::string_view name);

/// The life that runs, in lines.
void noteLife(std::string_view lines);

/// Writes the report; the handler calls it.
void writeCrashReport(int file, int signal);

}  // namespace surefoot
