// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot difference`: where two records of lives part, and in what.
#include "core/difference/difference.h"

#include "app/commands/commands.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"

namespace surefoot {

int differenceCommand(const Registry& registry, const DifferenceRequest& request) {
  const auto& [first, second, json] = request;
  if (first.empty() || second.empty())
    return fail({"FIRST SECOND: the names of two journals, checkpoints or logs are needed."});
  const auto found = differenceOf(registry, first, second, &watchForInterrupt());
  if (!found) return fail(found.error());
  const int printed = print(json ? differenceAsJson(*found) : differenceText(*found, first, second));
  return printed == kDone && found->differ() ? kDifferent : printed;
}

}  // namespace surefoot
