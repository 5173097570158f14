// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_time.h"
#include "core/environment_library.h"

#include "core/plans/plan_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

namespace surefoot {

namespace {

/// Learning steps per second on one core, and steps per episode, for lives whose length is given in episodes.
struct Speed {
  double steps, episode;
};

Speed speedOf(const std::string& environment) {
  static const std::map<std::string, Speed> kMeasured = {
      {"pendulum", {1.4e6, 70}}, {"leo", {12'500, 200}}, {"compass", {150'000, 60}}, {"mountain-car", {4e6, 150}}};
  const auto found = kMeasured.find(environment);
  return found == kMeasured.end() ? Speed{8e6, 40} : found->second;
}

double numberOf(const std::string& text, double otherwise) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && std::isfinite(value) ? value : otherwise;
}

double stepTimeOf(const Registry& registry, const std::string& environment) {
  const auto entry = findEnvironment(registry, environment);
  return entry ? (*entry)->make()->task().stepTime.value_or(0.0) : 0.0;
}

/// What pre-learning does not depend on: conditions that differ in nothing else share their Q-functions.
bool isOfLivesOnly(const std::string& key) {
  return key == "name" || key == "reference" || key == "policy" || key == "minutes" || key == "scenario" ||
         key.starts_with("set.policy.");
}

/// CPU seconds of one block: `lives` lives for every combination of its lists, and the pre-learning, unless it is among
/// the `lessons` of an earlier block.
double secondsOf(const Registry& registry, const PlanBlock& block, double lives, std::set<std::string>& lessons) {
  std::string lessonIs;
  double lessonsHere = 1, conditions = 1, minutes = 0, episodes = 0, until = 0, before = 0, pool = 5;
  std::string environment = "pendulum";
  bool preLearned = false;
  for (const PlanSetting& s : block.settings) {
    conditions *= static_cast<double>(s.values.size());
    if (!isOfLivesOnly(s.key)) {
      lessonsHere *= static_cast<double>(s.values.size());
      lessonIs += s.key + "=";
      for (const std::string& v : s.values) lessonIs += v + ",";
    }
    const std::string& value = s.values.back();
    if (s.key == "environment") environment = value;
    if (s.key == "minutes") minutes = numberOf(value, 0);
    if (s.key == "episodes") episodes = numberOf(value, 0);
    if (s.key == "pre-learning.until") until = numberOf(value, 0), preLearned = true;
    if (s.key == "pre-learning.minutes") before = numberOf(value, 0), preLearned = true;
    if (s.key == "pre-learning.pool") pool = value == "each" ? lives : numberOf(value, 5);
  }
  const Speed speed = speedOf(environment);
  const double stepTime = stepTimeOf(registry, environment);
  const auto steps = [&](double m) { return stepTime > 0 ? m * 60 / stepTime : 0; };
  const double life = minutes > 0 ? steps(minutes) : episodes * speed.episode;
  constexpr double kUntilReached = 9;  // simulated minutes until a reward is reached, about
  const double lesson = !preLearned ? 0 : steps(before > 0 ? before : until != 0 ? kUntilReached : 0);
  if (!lessons.insert(lessonIs).second) lessonsHere = 0;
  return (conditions * lives * life + lessonsHere * pool * lesson) / speed.steps;
}

}  // namespace

double minutesFor(const Registry& registry, const PlanFile& plan, int threads, std::optional<int> otherLives) {
  double lives = otherLives.value_or(40);
  for (const PlanSetting& s : plan.head)
    if (s.key == "lives" && !otherLives) lives = std::max(1.0, numberOf(s.values.front(), lives));
  const auto estimated = [&](double livesEach) {
    double seconds = 0;
    std::set<std::string> lessons;
    for (const PlanBlock& block : plan.blocks) seconds += secondsOf(registry, block, livesEach, lessons);
    return seconds * systemsIn(plan.systems);
  };
  if (plan.minutesOnTwoCores <= 0) return estimated(lives) / 60 / std::max(1, threads);
  const double measured = plan.minutesOnTwoCores * 2 / std::max(1, threads);
  const double then = plan.minutesForLives > 0 ? estimated(plan.minutesForLives) : 0.0;
  return then > 0 ? measured * estimated(lives) / then : measured;
}

std::string roundedTime(double minutes) {
  if (minutes < 1.0 / 60) return "1 s";
  if (minutes < 1) return fmt::format("{:.0f} s", std::ceil(minutes * 60 / 5) * 5);
  if (minutes < 90) return fmt::format("{:.0f} min", minutes);
  return fmt::format("{:.0f} h {:.0f} min", std::floor(minutes / 60), std::fmod(minutes, 60.0));
}

}  // namespace surefoot
