// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store_checks.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {
constexpr std::size_t kHashDigits = 16;

void addText(Hash64& hash, const std::string& text) {
  hash.add(static_cast<std::uint64_t>(text.size()));
  hash.add(std::string_view(text));
}
void addAll(Hash64& hash, auto... numbers) {
  (hash.add(static_cast<std::uint64_t>(numbers)), ...);
}
bool isHash(const std::string& text) {
  return text.size() == kHashDigits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}
}  // namespace

void CheckedRow::refuse(int column, const std::string& value) const {
  throw Damaged(fmt::format("in its table {} {} is {}", table_, row_.getColumnName(column), value));
}

std::int64_t CheckedRow::whole(int column, std::int64_t low, std::int64_t high) const {
  const SQLite::Column value = row_.getColumn(column);
  if (value.getType() != SQLITE_INTEGER) refuse(column, "no whole number");
  const std::int64_t number = value.getInt64();
  if (number < low || number > high) refuse(column, fmt::format("{}", number));
  return number;
}

double CheckedRow::real(int column) const {
  const SQLite::Column value = row_.getColumn(column);
  if (value.getType() != SQLITE_FLOAT && value.getType() != SQLITE_INTEGER) refuse(column, "no number");
  const double number = value.getDouble();
  if (!std::isfinite(number)) refuse(column, fmt::format("{}", number));
  return number;
}

std::string CheckedRow::text(int column, std::size_t most) const {
  const SQLite::Column value = row_.getColumn(column);
  if (value.getType() != SQLITE_TEXT) refuse(column, "no text");
  if (static_cast<std::size_t>(value.getBytes()) > most) refuse(column, fmt::format("longer than {} bytes", most));
  std::string text = value.getString();
  if (!isUtf8(text)) refuse(column, "no UTF-8");
  return text;
}

std::uint64_t CheckedRow::hash(int column) const {
  const std::string digits = text(column, 100);
  if (!isHash(digits)) refuse(column, fmt::format("\"{}\"", shortened(digits)));
  return std::strtoull(digits.c_str(), nullptr, 16);
}

void checkEpisodes(const StoredLife& life, const std::vector<StoredEpisode>& episodes) {
  const auto refuse = [&](const std::string& what) {
    throw Damaged(fmt::format("of life {} of condition {} {}", life.life, life.condition + 1, what));
  };
  std::int64_t falls = 0, steps = 0;
  for (const StoredEpisode& e : episodes) {
    falls += e.falls, steps += e.transitions;
    const bool fell = e.ending == EndingCode::Fall, ended = e.ending == EndingCode::End;
    if (e.falls > e.transitions || (fell && e.falls == 0) || (ended && e.falls > 0))
      refuse("an episode's falls do not go with its transitions and its ending");
  }
  if (static_cast<std::int64_t>(episodes.size()) != life.episodes)
    refuse(fmt::format("{} of {} episodes are there", episodes.size(), life.episodes));
  if (falls != life.falls || steps > life.steps) refuse("the episodes have other falls or steps than the life");
}

std::uint64_t checksumOf(const StoredLife& l) {
  Hash64 hash;
  addAll(hash, l.condition, l.life, l.qFunction, l.episodes, l.steps, l.falls, l.statesOutside, l.hash, l.livesVersion);
  addText(hash, l.diverged), addText(hash, l.program);
  return hash.value();
}

std::uint64_t checksumOf(const std::vector<StoredEpisode>& episodes) {
  Hash64 hash;
  for (const StoredEpisode& e : episodes) addAll(hash, e.transitions, e.falls, e.ending), hash.add(e.reward);
  return hash.value();
}

std::uint64_t checksumOf(std::vector<StoredMeasure> measures) {
  std::sort(measures.begin(), measures.end(), [](const StoredMeasure& a, const StoredMeasure& b) {
    return std::tie(a.episode, a.name) < std::tie(b.episode, b.name);
  });
  Hash64 hash;
  for (const StoredMeasure& m : measures) addAll(hash, m.episode), addText(hash, m.name), hash.add(m.value);
  return hash.value();
}

std::uint64_t checksumOf(const StoredPreLearning& p) {
  Hash64 hash;
  addAll(hash, p.condition, p.qFunction, p.episodes, p.falls, p.steps, p.reached, p.hash);
  hash.add(p.averageReward);
  return hash.value();
}

std::uint64_t checksumOf(const StoredPlan& plan) {
  Hash64 hash;
  addText(hash, plan.title), addText(hash, plan.version);
  addAll(hash, plan.seed, plan.paired, plan.shard, plan.shards);
  if (!plan.growth.empty()) addText(hash, plan.growth);
  for (const StoredCondition& c : plan.conditions) {
    for (const std::string* text : {&c.name, &c.reference, &c.text, &c.configuration}) addText(hash, *text);
    addAll(hash, c.lives);
    hash.add(c.goalReward), hash.add(c.stepTime);
  }
  return hash.value();
}

std::string checksumText(std::uint64_t life, std::uint64_t episodes, std::uint64_t measures) {
  return hexText(life) + hexText(episodes) + hexText(measures);
}

void compareChecksum(const std::string& text, ChecksumPart part, std::uint64_t sum, const std::string& what) {
  const std::size_t from = static_cast<std::size_t>(part) * kHashDigits;
  if (text.size() <= from || text.substr(from, kHashDigits) != hexText(sum))
    throw Damaged(what + " is not what was written");
}

std::string hexText(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}

}  // namespace surefoot
