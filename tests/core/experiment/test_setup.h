// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "core/experiment/configuration.h"
#include "tests/full_registry.h"

namespace surefoot {

inline Configuration pendulumConfiguration(const Registry& registry, const std::string& policy = "epsilon-greedy",
                                           const std::vector<Assignment>& assignments = {}) {
  Names names;
  names.policy = policy;
  auto configuration = configure(registry, names, assignments);
  EXPECT_TRUE(configuration) << configuration.error().message;
  return *configuration;
}

inline std::unique_ptr<Life> lifeOf(const Registry& registry, const Configuration& configuration) {
  auto life = makeLife(registry, configuration, 0, false);
  EXPECT_TRUE(life) << life.error().message;
  return std::move(*life);
}

}  // namespace surefoot
