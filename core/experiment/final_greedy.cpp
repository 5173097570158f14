// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/final_greedy.h"

#include "core/life/greedy_trial.h"

namespace surefoot {

Result<FinalGreedy> finalGreedy(const Registry& registry, Configuration configuration, const Life& life) {
  constexpr std::uint64_t kSeed = 1;  // for every life
  configuration.parameters = life.parameters();
  auto environment = makeEnvironment(registry, configuration);
  if (!environment) return environment.error();
  GreedyTester tester(std::move(*environment), kSeed);
  const double most = kMostShare * static_cast<double>(life.steps());
  FinalGreedy final;
  double steps = 0;
  while (final.episodes < kMostEpisodes && (final.episodes < kLeastEpisodes || steps < most)) {
    const std::string why = tester.test(life.agent().values(), life.policy(), ++final.episodes, life.steps());
    if (!why.empty()) return Error{why, ErrorKind::Unanswered};
    steps += static_cast<double>(tester.tests().back().steps);
  }
  for (const GreedyTest& t : tester.tests()) final.falls += t.falls, final.reward += t.reward;
  final.falls /= final.episodes;
  final.reward /= final.episodes;
  return final;
}

}  // namespace surefoot
