// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "core/files/read_file.h"
#include "core/life/episode_log.h"

namespace surefoot {

namespace {

constexpr std::size_t kFirst = 330, kSpan = 250;      // for the end of learning
constexpr double kMostChange = 3.0, kOfGoal = 200.0;  // the thesis's, and the goal reward that they belong to
constexpr std::size_t kLast = 500;                    // episodes for the end performance

double ratio(double sum, double count) {
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

Lengths lengthsOf(std::span<const StoredEpisode> episodes) {
  double successSteps = 0, successes = 0, failureSteps = 0, failures = 0;
  for (const StoredEpisode& e : episodes) {
    if (e.ending == EndingCode::Success) successSteps += static_cast<double>(e.transitions), ++successes;
    if (e.ending == EndingCode::Fall) failureSteps += static_cast<double>(e.transitions), ++failures;
  }
  return {ratio(successSteps, successes), ratio(failureSteps, failures)};
}

/// Mean transitions of an episode, whatever its ending.
double transitionsOf(std::span<const StoredEpisode> episodes) {
  double transitions = 0;
  for (const StoredEpisode& e : episodes) transitions += static_cast<double>(e.transitions);
  return ratio(transitions, static_cast<double>(episodes.size()));
}

double fallsOf(std::span<const StoredEpisode> episodes) {
  double falls = 0;
  for (const StoredEpisode& e : episodes) falls += e.falls;
  return falls;
}

double rewardOf(std::span<const StoredEpisode> episodes) {
  double reward = 0;
  for (const StoredEpisode& e : episodes) reward += e.reward;
  return ratio(reward, static_cast<double>(episodes.size()));
}

/// Falls of the episodes that were over by then; NaN if the life, of `steps` transitions, did not come to it.
double fallsByMinute(std::span<const StoredEpisode> episodes, std::int64_t steps, double stepTime, double minute) {
  constexpr double kRounding = 1e-9;
  const double most = minute * 60 / stepTime;  // transitions
  if (!(stepTime > 0) || static_cast<double>(steps) < most * (1 - kRounding))
    return std::numeric_limits<double>::quiet_NaN();
  double falls = 0, transitions = 0;
  for (const StoredEpisode& e : episodes) {
    transitions += static_cast<double>(e.transitions);
    if (transitions > most * (1 + kRounding)) break;
    falls += e.falls;
  }
  return falls;
}

double minutesOf(std::span<const StoredEpisode> episodes, double stepTime) {
  double transitions = 0;
  for (const StoredEpisode& e : episodes) transitions += static_cast<double>(e.transitions);
  return stepTime > 0 ? transitions * stepTime / 60.0 : std::numeric_limits<double>::quiet_NaN();
}

/// Mean and band over lives of the lives' values at x.
Curve overLives(const ConditionRecord& record, std::vector<double> x, const std::vector<std::vector<double>>& lives) {
  Curve curve{.x = std::move(x), .y = {}};
  const Units units = unitsOf(record);
  std::vector<double> values(lives.size());
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    for (std::size_t l = 0; l < lives.size(); ++l) values[l] = lives[l][i];
    curve.y.push_back(intervalOf(estimateOf(values, units)));
  }
  return curve;
}

using ValuesOfLife = std::function<std::vector<double>(const std::vector<StoredEpisode>&)>;

/// The results of `value` after every episode, up to the end of the shortest life.
Curve againstEpisodes(const ConditionRecord& record, const ValuesOfLife& value) {
  std::vector<double> x(record.shortest());
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = static_cast<double>(k + 1);
  std::vector<std::vector<double>> lives;
  for (const auto& episodes : record.episodes) lives.push_back(value(episodes));
  return overLives(record, std::move(x), lives);
}

/// The same at moments spread evenly in simulated time, from the moment when all lives have finished an episode.
/// Where the task has no clock: against episodes.
Curve againstMinutes(const ConditionRecord& record, std::size_t points, const ValuesOfLife& value) {
  if (!(record.condition.stepTime > 0)) return againstEpisodes(record, value);
  double first = 0, length = std::numeric_limits<double>::infinity();
  for (const auto& episodes : record.episodes) {
    if (episodes.empty()) return {};
    first = std::max(first, minutesOf({episodes.data(), 1}, record.condition.stepTime));
    length = std::min(length, minutesOf(episodes, record.condition.stepTime));
  }
  if (!std::isfinite(length) || points < 2) return {};
  std::vector<double> x;
  for (std::size_t i = 0; i < points; ++i) {
    const double moment = length * static_cast<double>(i) / static_cast<double>(points - 1);
    if (moment >= first) x.push_back(moment);
  }
  std::vector<std::vector<double>> lives;
  for (const auto& episodes : record.episodes) {
    const auto values = value(episodes);
    auto& y = lives.emplace_back();
    double minutes = 0;
    std::size_t over = 0;
    for (const double moment : x) {
      while (over < episodes.size()) {
        const double next = minutes + minutesOf({&episodes[over], 1}, record.condition.stepTime);
        if (next > moment * (1 + 1e-12)) break;
        minutes = next, ++over;
      }
      y.push_back(values[over - 1]);
    }
  }
  return overLives(record, std::move(x), lives);
}

double lastAverageReward(const std::vector<StoredEpisode>& episodes) {
  if (episodes.empty()) return std::nan("");
  const auto count = std::min<std::ptrdiff_t>(EpisodeLog::kAverageOver, std::ssize(episodes));
  return averageRewards({episodes.end() - count, episodes.end()}).back();
}

}  // namespace

std::size_t ConditionRecord::shortest() const {
  std::size_t shortest = episodes.empty() ? 0 : episodes[0].size();
  for (const auto& life : episodes) shortest = std::min(shortest, life.size());
  return shortest;
}

Result<std::vector<ConditionRecord>> readConditions(const Store& store) {
  auto plan = store.plan();
  if (!plan) return plan.error();
  const auto lives = store.lives();
  if (!lives) return lives.error();
  const auto before = store.preLearned();
  if (!before) return before.error();
  std::vector<ConditionRecord> records(plan->conditions.size());
  const auto known = [&](int condition) { return condition >= 0 && condition < static_cast<int>(records.size()); };
  const Error damaged =
      fileError(store.path(), "it holds lives of a condition that it does not hold; the file is damaged.");
  for (std::size_t i = 0; i < records.size(); ++i) records[i].condition = std::move(plan->conditions[i]);
  for (const StoredLife& life : *lives) {
    if (!known(life.condition)) return damaged;
    ConditionRecord& record = records[static_cast<std::size_t>(life.condition)];
    if (!life.diverged.empty()) {
      ++record.diverged;
      continue;
    }
    auto episodes = store.episodes(life.condition, life.life);
    if (!episodes) return episodes.error();
    record.paired = plan->paired;
    record.lives.push_back(life);
    record.episodes.push_back(std::move(*episodes));
    auto measures = store.measures(life.condition, life.life);
    if (!measures) return measures.error();
    record.measures.push_back(std::move(*measures));
  }
  for (const StoredPreLearning& p : *before) {
    if (!known(p.condition)) return damaged;
    records[static_cast<std::size_t>(p.condition)].preLearned.push_back(p);
  }
  return records;
}

std::vector<double> averageRewards(const std::vector<StoredEpisode>& episodes) {
  constexpr std::size_t kOver = EpisodeLog::kAverageOver;
  std::vector<double> rewards, averages(episodes.size());
  for (const StoredEpisode& e : episodes) rewards.push_back(e.reward);
  // Every sum from its oldest reward on; all sums side by side, so that none waits for itself.
  for (std::size_t before = kOver; before-- > 0;)
    for (std::size_t k = before; k < rewards.size(); ++k) averages[k] += rewards[k - before];
  for (std::size_t k = 0; k < averages.size(); ++k) averages[k] /= static_cast<double>(std::min(k + 1, kOver));
  return averages;
}

std::vector<double> meanAverageRewards(const ConditionRecord& record) {
  std::vector<double> a(record.shortest());
  for (const auto& episodes : record.episodes) {
    const auto averages = averageRewards(episodes);
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += averages[k];
  }
  for (double& mean : a) mean /= static_cast<double>(record.episodes.size());
  return a;
}

std::optional<std::size_t> endOfLearning(const std::vector<double>& a, double goalReward) {
  constexpr double kRounding = 1e-9;  // changes lie on a grid of rewards over lives: one of exactly 3 is not below 3
  const double most = (goalReward > 0 ? kMostChange * goalReward / kOfGoal : kMostChange) - kRounding;
  for (std::size_t k = kFirst; k <= a.size(); ++k)
    if (std::abs(a[k - 1] - a[k - 1 - kSpan]) < most && a[k - 1] > 0.75 * goalReward) return k;
  return std::nullopt;
}

double largestChangeAfter(const std::vector<double>& a, std::size_t end) {
  double largest = 0;
  for (std::size_t k = std::max(end + 1, kSpan + 1); k <= a.size(); ++k)
    largest = std::max(largest, std::abs(a[k - 1] - a[k - 1 - kSpan]));
  return largest;
}

std::vector<LifeMeasures> measure(const ConditionRecord& record, std::optional<std::size_t> end) {
  std::vector<LifeMeasures> all;
  for (const auto& episodes : record.episodes) {
    const std::span<const StoredEpisode> whole(episodes);
    const auto during = whole.first(std::min(end.value_or(whole.size()), whole.size()));
    const auto after = whole.subspan(during.size());
    const auto last = whole.last(std::min(kLast, whole.size()));
    all.push_back(
        {.falls = fallsOf(during),
         .minutes = minutesOf(during, record.condition.stepTime),
         .allFalls = fallsOf(whole),
         .endPerformance = ratio(fallsOf(last), static_cast<double>(last.size())),
         .averageReward = lastAverageReward(episodes),
         .lifeReward = rewardOf(whole),
         .firstTransitions = transitionsOf(whole.first(std::min<std::size_t>(EpisodeLog::kAverageOver, whole.size()))),
         .during = lengthsOf(during),
         .after = lengthsOf(after)});
    LifeMeasures& life = all.back();
    for (std::size_t m = 0; m < kFixedMinutes.size(); ++m)
      life.fallsByMinute[m] =
          fallsByMinute(whole, record.lives[all.size() - 1].steps, record.condition.stepTime, kFixedMinutes[m]);
    life.fallsByEpisode = whole.size() >= kFixedEpisodes ? fallsOf(whole.first(kFixedEpisodes)) : std::nan("");
    if (all.size() <= record.measures.size())
      for (const StoredMeasure& m : record.measures[all.size() - 1])
        if (m.episode == 0) all.back().own.push_back(m);
  }
  return all;
}

std::vector<double> fallsUntil(const ConditionRecord& record, std::size_t episode) {
  std::vector<double> falls;
  for (const auto& episodes : record.episodes)
    falls.push_back(fallsOf(std::span(episodes).first(std::min(episode, episodes.size()))));
  return falls;
}

Units unitsOf(const ConditionRecord& record) {
  std::map<int, std::size_t> numbers;
  for (const StoredLife& l : record.lives) numbers[l.qFunction] = 0;
  if (numbers.size() < 2) return Units::each(record.lives.size());
  Units units{.of = {}, .areQFunctions = true};
  for (auto& [qFunction, number] : numbers) number = units.count++;
  for (const StoredLife& l : record.lives) units.of.push_back(numbers[l.qFunction]);
  return units;
}

Groups byQFunction(const ConditionRecord& record, Sample values) {
  std::map<int, std::vector<double>> groups;
  for (std::size_t i = 0; i < values.size(); ++i) groups[record.lives[i].qFunction].push_back(values[i]);
  Groups list;
  for (auto& [number, group] : groups) list.push_back(std::move(group));
  return list;
}

Curve learningCurve(const ConditionRecord& record, std::size_t points) {
  return againstMinutes(record, points, averageRewards);
}

Curve cumulativeFalls(const ConditionRecord& record, std::size_t points) {
  return againstMinutes(record, points, [](const std::vector<StoredEpisode>& episodes) {
    std::vector<double> falls;
    for (const StoredEpisode& e : episodes) falls.push_back((falls.empty() ? 0.0 : falls.back()) + e.falls);
    return falls;
  });
}

Curve rewardAgainstFalls(const ConditionRecord& record) {
  std::size_t most = 0;
  std::vector<std::vector<double>> lives;
  for (const auto& episodes : record.episodes) {
    const auto averages = averageRewards(episodes);
    auto& values = lives.emplace_back();
    for (std::size_t k = 0; k < episodes.size(); ++k)
      for (int fall = 0; fall < episodes[k].falls; ++fall) values.push_back(averages[k]);
    most = std::max(most, values.size());
    values.push_back(averages.empty() ? 0.0 : averages.back());
  }
  std::vector<double> x(most);
  for (std::size_t f = 0; f < most; ++f) x[f] = static_cast<double>(f + 1);
  for (auto& values : lives) values.resize(most, values.back());
  return overLives(record, std::move(x), lives);
}

}  // namespace surefoot
