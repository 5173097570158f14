// SPDX-License-Identifier: GPL-3.0-or-later
// The pendulum from a file is the compiled one, bit for bit.
#include "core/experiment/configuration.h"
#include "tests/physics/robot/robot_files.h"

namespace surefoot {

namespace {

std::uint64_t hashAfter(const Registry& registry, const std::string& environment,
                        const std::vector<Assignment>& assignments, int episodes) {
  Names names;
  names.environment = environment;
  auto configuration = configure(registry, names, assignments);
  if (!configuration) return ADD_FAILURE() << configuration.error().message, 0;
  configuration->episodes = episodes;
  auto life = makeLife(registry, *configuration, 0, false);
  if (!life) return ADD_FAILURE() << life.error().message, 0;
  while (!(*life)->finished()) (*life)->step();
  EXPECT_EQ((*life)->log().totals().episodes, episodes);
  return (*life)->hash();
}

}  // namespace

TEST(RobotPendulum, LivesTheLifeOfTheCompiledOne) {
  const Registry registry = registryWith("pendulum");
  const std::vector<std::vector<Assignment>> scenarios = {
      {},
      {{"environment.damping", "0.088"}, {"environment.friction", "0.03"}},
      {{"environment.damping", "0.04"}, {"environment.friction", "0.02"}},
      {{"environment.damping", "0.01"}, {"environment.friction", "0.05"}},
      {{"environment.torque_scale", "2.5"}},
      {{"environment.torque_scale", "0.5"}},
      {{"environment.damping", "0.088"}, {"environment.friction", "0.03"}, {"environment.torque_scale", "2.5"}}};
  for (std::size_t s = 0; s < scenarios.size(); ++s)
    EXPECT_EQ(hashAfter(registry, "pendulum-file", scenarios[s], 400),
              hashAfter(registry, "pendulum", scenarios[s], 400))
        << s;
}

}  // namespace surefoot
