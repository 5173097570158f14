// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/task/mishaps.h"

#include <fmt/format.h>

namespace surefoot {

Outcome Mishaps::cutOff(RobotValues& values) {
  ++counts_.all;
  ++counts_.inARow;
  notFinite_ = values.notFinite();
  values.forgetEnding();
  Outcome outcome;
  outcome.ending = Ending::Truncated;
  return outcome;
}

std::string Mishaps::failure(const RobotSpec& spec, std::span<const double> parameters) const {
  if (counts_.inARow < kMostInARow) return {};
  if (!notFinite_.empty())
    return fmt::format(
        "The robot {} was cut off in {} episodes in a row: {} came to a number that is none, as a "
        "division by zero or the root of a negative number does.",
        spec.name, kMostInARow, notFinite_);
  std::string changed;
  for (std::size_t p = 0; p < spec.parameters.size(); ++p)
    if (const double value = parameters[p]; value != spec.defaults[p])
      changed += fmt::format("{}environment.{} = {}", changed.empty() ? "" : ", ", spec.parameters[p].key, value);
  return fmt::format("The robot {} flew apart in {} episodes in a row: {}.", spec.name, kMostInARow,
                     changed.empty() ? "more substeps, weaker springs or smaller efforts may hold it together"
                                     : changed + " may be the cause");
}

}  // namespace surefoot
