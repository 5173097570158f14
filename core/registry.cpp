// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/registry.h"

#include <fmt/format.h>

#include "core/environment_library.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

Error unknownName(std::string_view what, std::string_view name, const std::vector<std::string>& names) {
  const std::string near = nearestWord(name, names);
  return Error{fmt::format("{}: there is no \"{}\"{}; choose {}.", what, shortened(name),
                           near.empty() ? "" : fmt::format(", did you mean {}", near), joinWords(names, "or"))};
}

std::vector<TaskMeasure> taskMeasuresOf(const Registry& registry, const std::set<std::string>& environments) {
  std::vector<TaskMeasure> all;
  for (const std::string& name : environments) {
    const auto entry = findEnvironment(registry, name);
    if (!entry) continue;
    const auto environment = (*entry)->make();
    for (const TaskMeasure& m : environment->task().measures)
      if (!measureAt(all, m.key)) all.push_back(m);
  }
  return all;
}

}  // namespace surefoot
