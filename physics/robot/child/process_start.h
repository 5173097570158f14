// SPDX-License-Identifier: GPL-3.0-or-later
// Starts a program with a socket at its standard input and output, and a pipe at its standard error. It gets the
// program's environment and nothing else of this process, and ends when this process ends, however that comes. Any
// thread.
#pragma once

#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

struct StartedProcess {
  int id, channel, errors;  ///< the channel waits 20 ms at most; errors never waits
};

/// `environment`: "NAME=value".
Result<StartedProcess> startProcess(const std::vector<std::string>& command,
                                    const std::vector<std::string>& environment);

}  // namespace surefoot
