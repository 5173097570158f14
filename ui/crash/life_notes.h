// SPDX-License-Identifier: GPL-3.0-or-later
// What a report of a crash says of the life: names of parts and every parameter; of a robot from a file nothing that
// its author wrote, and no name of a file. Window's thread.
#pragma once

#include <string>

namespace surefoot {

struct Configuration;
class RunningLife;

/// In lines: "  environment = pendulum".
std::string lifeLines(const Configuration& configuration);

/// Keeps the notes (crash_notes.h) up to date: the life's configuration, and the parameters that a person changes.
void noteChangesOf(RunningLife& life);

}  // namespace surefoot
