// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_programs.h"

#include "core/environment_library.h"
#include "core/environment_programs.h"

namespace surefoot {

std::vector<std::shared_ptr<const EnvironmentFile>> programsToAllow(const Registry& registry, const Plan& plan) {
  std::vector<std::shared_ptr<const EnvironmentFile>> files;
  const auto look = [&](const Configuration& c) {
    if (isMovedByProgram(c) && registry.programs && !registry.programs->isAllowed(c.environmentFile->program))
      files.push_back(c.environmentFile);
  };
  for (const Condition& condition : plan.conditions) {
    look(condition.configuration);
    if (condition.preLearning) look(condition.preLearning->configuration);
  }
  return files;
}

Status checkPrograms(const Registry& registry, const Plan& plan) {
  const auto files = programsToAllow(registry, plan);
  if (files.empty()) return Done{};
  Random random(0);
  const auto robot = files.front()->entry.make();
  robot->reset(random);  // it says what it would start
  return Error{robot->unanswered(), ErrorKind::Unanswered};
}

}  // namespace surefoot
