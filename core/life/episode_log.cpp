// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/episode_log.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/basics/random.h"
#include "core/life/life_measures.h"

namespace surefoot {

EpisodeLog::EpisodeLog(bool keepRows, const std::vector<TaskMeasure>& measures) : keepRows_(keepRows) {
  for (std::size_t m = 0; m < measures.size(); ++m) ofALife_[m] = measures[m].ofALife;
}

const EpisodeRow& EpisodeLog::finish(Ending ending, std::int64_t lifeSteps, double bestReturn,
                                     std::span<const double> measures) {
  recent_[static_cast<std::size_t>(totals_.episodes % kAverageOver)] = current_.reward;
  ++totals_.episodes;
  totals_.falls += current_.falls;
  totals_.rewinds += current_.rewinds;
  const bool failure = !current_.success && current_.falls > 0;
  totals_.successes += current_.success;
  totals_.failures += failure;
  if (current_.success) totals_.successSteps += current_.steps;
  if (failure) totals_.failureSteps += current_.steps;
  if (current_.success && end_.reached()) ++totals_.successesAfter, totals_.successStepsAfter += current_.steps;

  const auto count = std::min<std::int64_t>(totals_.episodes, kAverageOver);
  double sum = 0.0;
  for (std::int64_t i = 0; i < count; ++i) sum += recent_[static_cast<std::size_t>(i)];

  last_ = current_;
  last_.episode = totals_.episodes;
  last_.lifeSteps = lifeSteps;
  last_.ending = ending;
  last_.averageReward = sum / static_cast<double>(count);
  std::copy(measures.begin(), measures.end(), last_.measures.begin());
  for (std::size_t m = 0; m < measures.size(); ++m)
    totals_.measures[m] = together(ofALife_[m], totals_.measures[m], measures[m], totals_.episodes == 1);
  totals_.highestReward = std::max(totals_.highestReward, last_.highest);
  current_ = {};
  end_.add(last_.episode, last_.averageReward, lifeSteps, bestReturn);

  for (const auto word : {last_.episode, last_.steps, last_.lifeSteps, static_cast<std::int64_t>(last_.falls),
                          static_cast<std::int64_t>(last_.success), static_cast<std::int64_t>(last_.ending)})
    hash_.add(static_cast<std::uint64_t>(word));
  hash_.add(last_.reward);
  if (last_.rewinds > 0) hash_.add(static_cast<std::uint64_t>(last_.rewinds));
  for (const double measure : measures) hash_.add(measure);
  if (keepRows_) rows_.push_back(last_);
  return last_;
}

namespace {

/// Rows as columns.
void transferRows(Archive& archive, const std::string& name, std::vector<EpisodeRow>& rows) {
  constexpr std::size_t kMost = 1'000'000'000;
  std::vector<std::int64_t> episode, steps, lifeSteps, falls, rewinds;
  std::vector<double> reward, average, measures, highest;
  std::vector<std::uint8_t> success, ending;
  for (const EpisodeRow& r : rows) {
    episode.push_back(r.episode), steps.push_back(r.steps), lifeSteps.push_back(r.lifeSteps), falls.push_back(r.falls);
    reward.push_back(r.reward), average.push_back(r.averageReward);
    success.push_back(r.success), ending.push_back(static_cast<std::uint8_t>(r.ending));
    measures.insert(measures.end(), r.measures.begin(), r.measures.end());
    highest.push_back(r.highest);
    rewinds.push_back(r.rewinds);
  }
  const bool rewound = std::any_of(rewinds.begin(), rewinds.end(), [](std::int64_t count) { return count > 0; });
  archive.under(name + ".", [&] {
    archive.list("episode", episode, kMost);
    archive.list("steps", steps, kMost);
    archive.list("life_steps", lifeSteps, kMost);
    archive.list("falls", falls, kMost);
    archive.list("reward", reward, kMost);
    archive.list("average_reward", average, kMost);
    archive.list("success", success, kMost);
    archive.list("ending", ending, kMost);
    archive.list("measures", measures, kMost * kMaxMeasures);
    archive.list("highest", highest, kMost);
    const std::size_t n = episode.size();
    if (archive.reading() ? archive.has("rewinds") : rewound)  // in most lives no fall is taken back
      archive.list("rewinds", rewinds, kMost);
    else
      rewinds.assign(n, 0);
    for (const std::size_t size :
         {steps.size(), lifeSteps.size(), falls.size(), reward.size(), average.size(), success.size(), ending.size(),
          measures.size() / kMaxMeasures, highest.size(), rewinds.size()})
      if (size != n) archive.refuse("episode", "is not as long as the other columns");
    if (!archive.reading() || !archive.good()) return;
    rows.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      if (ending[i] > static_cast<std::uint8_t>(Ending::Truncated)) return archive.refuse("ending", "is out of range");
      for (const std::int64_t count : {episode[i], steps[i], lifeSteps[i]})
        if (count < 0 || count > kMostLifeSteps)
          return archive.refuse("episode", "or a column beside it is out of range");
      for (const auto& [column, count] : {std::pair{"falls", falls[i]}, std::pair{"rewinds", rewinds[i]}})
        if (count < 0 || count > std::numeric_limits<int>::max()) return archive.refuse(column, "is out of range");
      if (i > 0 && (episode[i] <= episode[i - 1] || lifeSteps[i] < lifeSteps[i - 1]))
        return archive.refuse("episode", "is not in order");
      rows[i] = {episode[i],
                 steps[i],
                 lifeSteps[i],
                 reward[i],
                 static_cast<int>(falls[i]),
                 success[i] != 0,
                 static_cast<Ending>(ending[i]),
                 average[i],
                 {},
                 highest[i],
                 static_cast<int>(rewinds[i])};
      for (std::size_t m = 0; m < kMaxMeasures; ++m) rows[i].measures[m] = measures[i * kMaxMeasures + m];
    }
  });
}

void transferRow(Archive& archive, const std::string& name, EpisodeRow& row) {
  std::vector<EpisodeRow> rows = {row};
  transferRows(archive, name, rows);
  if (rows.size() != 1) return archive.refuse(name + ".episode", "is not one row");
  row = rows.front();
}

}  // namespace

void EpisodeLog::transfer(Archive& archive) {
  transferRow(archive, "current", current_);
  transferRow(archive, "last", last_);
  transferRows(archive, "rows", rows_);
  archive.table("recent", recent_);
  std::uint64_t hash = hash_.value();
  archive.value("hash", hash);
  hash_.setValue(hash);
  for (const auto& [name, total] :
       {std::pair{"episodes", &totals_.episodes}, std::pair{"falls", &totals_.falls},
        std::pair{"successes", &totals_.successes}, std::pair{"failures", &totals_.failures},
        std::pair{"success_steps", &totals_.successSteps}, std::pair{"failure_steps", &totals_.failureSteps},
        std::pair{"successes_after", &totals_.successesAfter},
        std::pair{"success_steps_after", &totals_.successStepsAfter}})
    archive.value(name, *total, 0, kMostLifeSteps);
  if (archive.reading() ? archive.has("rewinds") : totals_.rewinds > 0)
    archive.value("rewinds", totals_.rewinds, 0, kMostLifeSteps);
  archive.table("measures", totals_.measures);
  archive.value("highest_reward", totals_.highestReward);
  archive.under("end_of_learning.", [&] { end_.transfer(archive); });
  if (totals_.successes + totals_.failures > totals_.episodes || totals_.successesAfter > totals_.successes)
    archive.refuse("episodes", "is less than its successes and failures");
  if (end_.episode() > totals_.episodes) archive.refuse("end_of_learning.episode", "has not been yet");
}

}  // namespace surefoot
