// SPDX-License-Identifier: GPL-3.0-or-later
// Lives made by hand, whose means are known, for claims to be judged on.
#pragma once

#include <gtest/gtest.h>

#include "core/agents/register.h"
#include "core/recipes/claim.h"
#include "core/register/register.h"

namespace surefoot {

using Json = nlohmann::json;

/// A condition whose lives fall about `mean` times, a little more or less (± 10 %), in one long quiet life.
inline Evidence condition(const std::string& name, double mean, const std::string& reference = "", double scatter = 0.1,
                          int lives = 20) {
  Evidence e;
  e.record.condition.name = name;
  e.record.condition.reference = reference;
  e.configuration = {{"parameters", {{"agent.step_size", mean / 100}}}};
  for (int i = 0; i < lives; ++i) {
    e.record.lives.push_back({});
    e.record.lives.back().life = i;
    LifeMeasures life;
    life.falls = mean * (1 + scatter * ((i % 5) - 2) / 1.5);
    life.minutes = mean / 50;
    life.during = {mean, mean + 10};
    e.lives.push_back(life);
  }
  return e;
}

inline const Registry kRegistry = [] {
  Registry registry;
  registerCore(registry);
  return registry;
}();

/// A list of lists, which nlohmann/json would take for an object.
inline Json pairs(const std::vector<std::vector<std::string>>& list) {
  return list;
}

}  // namespace surefoot
