// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/uncertain_end.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

constexpr int kResamples = 200;
constexpr std::uint64_t kSeed = 1;  // for all conditions: those with the same units get the same resamples

enum Sum { Falls, Transitions, Successes, SuccessSteps, Failures, FailureSteps };
using Sums = std::array<double, 6>;

/// The course of a life: the average reward after every episode, and sums over all episodes up to each one.
struct Course {
  std::vector<double> averages;
  std::vector<Sums> upTo;  ///< [k]: sums over the first k episodes
};

Course courseOf(const std::vector<StoredEpisode>& episodes) {
  Course course{.averages = averageRewards(episodes), .upTo = {Sums{}}};
  for (const StoredEpisode& e : episodes) {
    Sums s = course.upTo.back();
    const auto steps = static_cast<double>(e.transitions);
    s[Falls] += e.falls, s[Transitions] += steps;
    if (e.ending == EndingCode::Success) ++s[Successes], s[SuccessSteps] += steps;
    if (e.ending == EndingCode::Fall) ++s[Failures], s[FailureSteps] += steps;
    course.upTo.push_back(s);
  }
  return course;
}

/// A(k) over the lives, where life i counts times[i] times.
std::vector<double> meanAverages(const std::vector<Course>& lives, const std::vector<int>& times) {
  std::size_t shortest = lives[0].averages.size();
  double all = 0;
  for (std::size_t l = 0; l < lives.size(); ++l) {
    if (times[l] == 0) continue;
    shortest = all == 0 ? lives[l].averages.size() : std::min(shortest, lives[l].averages.size());
    all += times[l];
  }
  std::vector<double> a(shortest);
  for (std::size_t l = 0; l < lives.size(); ++l)
    for (std::size_t k = 0; times[l] > 0 && k < shortest; ++k) a[k] += times[l] * lives[l].averages[k];
  for (double& mean : a) mean /= all;
  return a;
}

struct OfLife {
  const char* name;
  double (*value)(const Sums& during, const Sums& after, double stepTime);
};
constexpr OfLife kOfLives[] = {
    {"falls", [](const Sums& d, const Sums&, double) { return d[Falls]; }},
    {"minutes", [](const Sums& d, const Sums&, double step) { return d[Transitions] * step / 60; }},
    {"success_during", [](const Sums& d, const Sums&, double) { return d[SuccessSteps] / d[Successes]; }},
    {"success_after", [](const Sums&, const Sums& a, double) { return a[SuccessSteps] / a[Successes]; }},
    {"failure_during", [](const Sums& d, const Sums&, double) { return d[FailureSteps] / d[Failures]; }},
    {"failure_after", [](const Sums&, const Sums& a, double) { return a[FailureSteps] / a[Failures]; }}};

/// Mean of the lives that have a value.
double meanUntil(const OfLife& measure, const std::vector<Course>& lives, const std::vector<int>& times,
                 std::optional<std::size_t> end, double stepTime) {
  double sum = 0, all = 0;
  for (std::size_t l = 0; l < lives.size(); ++l) {
    if (times[l] == 0) continue;
    const Sums& whole = lives[l].upTo.back();
    const Sums& during = end && *end < lives[l].upTo.size() ? lives[l].upTo[*end] : whole;
    Sums after{};
    for (std::size_t i = 0; i < after.size(); ++i) after[i] = whole[i] - during[i];
    const double value = measure.value(during, after, stepTime);
    if (std::isfinite(value)) sum += times[l] * value, all += times[l];
  }
  return sum / all;
}

}  // namespace

std::map<std::string, std::vector<double>, std::less<>> resampledUntilEnd(const ConditionRecord& record,
                                                                          std::optional<std::size_t> end) {
  std::map<std::string, std::vector<double>, std::less<>> means;
  const Units units = unitsOf(record);
  if (units.count < 2 || record.episodes.size() != units.of.size()) return means;
  std::vector<Course> lives;
  for (const auto& episodes : record.episodes) lives.push_back(courseOf(episodes));
  Random random(kSeed);
  bool elsewhere = false;
  std::vector<int> ofUnits(units.count), times(lives.size());
  for (int i = 0; i < kResamples; ++i) {
    std::fill(ofUnits.begin(), ofUnits.end(), 0);
    for (std::size_t g = 0; g < units.count; ++g)
      ++ofUnits[static_cast<std::size_t>(random.uniform() * static_cast<double>(units.count))];
    for (std::size_t l = 0; l < lives.size(); ++l) times[l] = ofUnits[units.of[l]];
    const auto thisEnd = endOfLearning(meanAverages(lives, times), record.condition.goalReward);
    elsewhere = elsewhere || thisEnd != end;
    means["end"].push_back(thisEnd ? static_cast<double>(*thisEnd) : std::numeric_limits<double>::infinity());
    for (const OfLife& m : kOfLives)
      if (const double mean = meanUntil(m, lives, times, thisEnd, record.condition.stepTime); std::isfinite(mean))
        means[m.name].push_back(mean);
  }
  if (!elsewhere) means.clear();
  std::erase_if(means, [](const auto& m) { return m.second.size() < kResamples; });
  return means;
}

}  // namespace surefoot
