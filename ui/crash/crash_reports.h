// SPDX-License-Identifier: GPL-3.0-or-later
// The files of reports in the user's data folder. A window that crashes leaves one of its own; the next start makes the
// newest the last one and removes those before, so there is never more than this one. Window's thread.
#pragma once

#include <QString>

namespace surefoot {

/// Where this process is to leave its report, if it crashes.
QString crashFile(const QString& folder);
/// Whether a window crashed since the last start: its report is the last one from now on. One of several starts at the
/// same time is told.
bool takeNewCrash(const QString& folder);
/// The report of the last crash; empty: there is none.
QString lastCrash(const QString& folder);

}  // namespace surefoot
