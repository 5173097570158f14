// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_combination.h"

#include <fmt/format.h>

#include <algorithm>

namespace surefoot {

std::vector<Combination> combine(const PlanBlock& block) {
  std::vector<Combination> grid(1);
  for (const PlanSetting& setting : block.settings) {
    std::vector<Combination> longer;
    for (const Combination& sofar : grid)
      for (const std::string& value : setting.values) {
        longer.push_back(sofar);
        longer.back().where[setting.key] = &setting;
        longer.back().all.push_back({setting.key, value});
        if (setting.values.size() > 1) longer.back().varied.push_back({setting.key, value});
        if (longer.size() > kMostConditions) return longer;
      }
    grid = std::move(longer);
  }
  return grid;
}

std::string nameOf(const Combination& c, std::string name, bool whole) {
  for (const Assignment& a : c.all) {
    const std::string key = a.key.starts_with("set.") ? a.key.substr(4) : a.key, mark = "{" + key + "}";
    const auto place = name.find(mark);
    const bool varied = std::any_of(c.varied.begin(), c.varied.end(), [&](const auto& v) { return v.key == a.key; });
    if (place != std::string::npos)
      name.replace(place, mark.size(), a.value);
    else if (varied && whole)
      name += fmt::format("{}{} {}", name.empty() ? "" : ", ", key, a.value);
  }
  return name;
}

std::string placeholderIn(const std::string& name) {
  const auto begin = name.find('{'), end = name.find('}', begin);
  if (begin == std::string::npos || end == std::string::npos) return "";
  const std::string inside = name.substr(begin + 1, end - begin - 1);
  const bool key = inside.find('.') != std::string::npos && inside.find(' ') == std::string::npos;
  return key ? name.substr(begin, end - begin + 1) : "";
}

}  // namespace surefoot
