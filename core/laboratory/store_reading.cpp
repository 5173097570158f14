// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <map>

#include "core/experiment/q_file.h"
#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/laboratory/store_database.h"

namespace surefoot {

namespace {

std::uint64_t fromHex(const std::string& text) {
  return std::strtoull(text.c_str(), nullptr, 16);
}

}  // namespace

Result<StoredPlan> Store::plan() const {
  return guarded<StoredPlan>(path_, [&]() -> Result<StoredPlan> {
    StoredPlan plan;
    std::map<std::string, std::string> pairs;
    SQLite::Statement pair(database_->db, "SELECT key, value FROM experiment");
    while (pair.executeStep()) pairs[pair.getColumn(0).getString()] = pair.getColumn(1).getString();
    plan.version = pairs["version"], plan.title = pairs["title"];
    plan.seed = std::strtoull(pairs["seed"].c_str(), nullptr, 10);
    plan.paired = pairs["paired"] == "1";
    plan.shard = std::max(1, std::atoi(pairs["shard"].c_str()));
    plan.shards = std::max(1, std::atoi(pairs["shards"].c_str()));
    SQLite::Statement row(database_->db,
                          "SELECT name, reference, text, configuration, lives, goal_reward, step_time FROM conditions "
                          "ORDER BY condition");
    while (row.executeStep())
      plan.conditions.push_back({row.getColumn(0), row.getColumn(1), row.getColumn(2), row.getColumn(3),
                                 row.getColumn(4).getInt(), row.getColumn(5).getDouble(),
                                 row.getColumn(6).getDouble()});
    if (plan.conditions.empty()) return fileError(path_, "it holds no condition; the file is damaged.");
    for (const StoredCondition& c : plan.conditions)
      if (!parseJson(c.configuration).is_object())
        return fileError(path_, "a condition has no configuration; the file is damaged.");
    return plan;
  });
}

Result<std::vector<StoredLife>> Store::lives() const {
  return guarded<std::vector<StoredLife>>(path_, [&] {
    std::vector<StoredLife> lives;
    const bool noted = database_->db.execAndGet("PRAGMA user_version").getInt() > kOldestFormat;
    SQLite::Statement row(database_->db,
                          std::string("SELECT condition, life, ifnull(q_function, -1), episodes, steps, falls, "
                                      "states_outside, ifnull(diverged, ''), hash, ") +
                              (noted ? "ifnull(lives_version, 0), ifnull(program, '')" : "0, ''") +
                              " FROM lives ORDER BY condition, life");
    while (row.executeStep())
      lives.push_back({row.getColumn(0), row.getColumn(1), row.getColumn(2), row.getColumn(3).getInt64(),
                       row.getColumn(4).getInt64(), row.getColumn(5).getInt64(), row.getColumn(6).getInt64(),
                       row.getColumn(7), fromHex(row.getColumn(8)), row.getColumn(9), row.getColumn(10)});
    return lives;
  });
}

Result<std::vector<StoredPreLearning>> Store::preLearned() const {
  return guarded<std::vector<StoredPreLearning>>(path_, [&] {
    std::vector<StoredPreLearning> all;
    SQLite::Statement row(database_->db,
                          "SELECT condition, q_function, episodes, falls, steps, average_reward, reached, hash FROM "
                          "pre_learned ORDER BY condition, q_function");
    while (row.executeStep())
      all.push_back({row.getColumn(0), row.getColumn(1), row.getColumn(2).getInt64(), row.getColumn(3).getInt64(),
                     row.getColumn(4).getInt64(), row.getColumn(5).getDouble(), row.getColumn(6).getInt() != 0,
                     fromHex(row.getColumn(7))});
    return all;
  });
}

Result<std::vector<StoredEpisode>> Store::episodes(int condition, int life) const {
  return guarded<std::vector<StoredEpisode>>(path_, [&] {
    std::vector<StoredEpisode> episodes;
    SQLite::Statement row(database_->db,
                          "SELECT transitions, reward, falls, ending FROM episodes WHERE condition = ? AND life = ? "
                          "ORDER BY episode");
    SQLite::bind(row, condition, life);
    while (row.executeStep())
      episodes.push_back({row.getColumn(0).getInt64(), row.getColumn(1).getDouble(), row.getColumn(2).getInt(),
                          static_cast<EndingCode>(row.getColumn(3).getInt())});
    return episodes;
  });
}

Result<std::vector<StoredMeasure>> Store::measures(int condition, int life) const {
  return guarded<std::vector<StoredMeasure>>(path_, [&] {
    std::vector<StoredMeasure> measures;
    if (!database_->db.tableExists("measures")) return measures;
    SQLite::Statement row(database_->db,
                          "SELECT episode, name, value FROM measures WHERE condition = ? AND life = ? ORDER BY "
                          "episode, name");
    SQLite::bind(row, condition, life);
    while (row.executeStep())
      measures.push_back({row.getColumn(0).getInt64(), row.getColumn(1), row.getColumn(2).getDouble()});
    return measures;
  });
}

Result<std::shared_ptr<const TensorFile>> Store::qFunction(const std::string& content) const {
  using File = std::shared_ptr<const TensorFile>;
  return guarded<File>(path_, [&]() -> Result<File> {
    if (!database_->db.tableExists("q_functions")) return File();
    SQLite::Statement row(database_->db, "SELECT file FROM q_functions WHERE content = ?");
    SQLite::bind(row, content);
    if (!row.executeStep()) return File();
    const SQLite::Column bytes = row.getColumn(0);
    const std::string_view blob(static_cast<const char*>(bytes.getBlob()), static_cast<std::size_t>(bytes.getBytes()));
    auto file = TensorFile::parse(blob, path_);
    if (!file) return file.error();
    if (contentOf(*file) != content) return fileError(path_, "a Q-function in it is damaged.");
    return std::make_shared<const TensorFile>(std::move(*file));
  });
}

Result<std::uint64_t> Store::contentHash() const {
  Hash64 hash;
  const auto addText = [&](const std::string& text) {
    hash.add(static_cast<std::uint64_t>(text.size()));
    hash.add(std::string_view(text));
  };
  const auto addAll = [&](auto... numbers) { (hash.add(static_cast<std::uint64_t>(numbers)), ...); };
  const auto stored = plan();
  if (!stored) return stored.error();
  addText(stored->title), addAll(stored->seed, stored->paired);
  for (const StoredCondition& c : stored->conditions) {
    addText(c.name), addText(c.reference), addText(c.text), addText(c.configuration), addAll(c.lives);
    hash.add(c.goalReward), hash.add(c.stepTime);
  }
  const auto pre = preLearned();
  if (!pre) return pre.error();
  for (const StoredPreLearning& p : *pre) {
    addAll(p.condition, p.qFunction, p.episodes, p.falls, p.steps, p.reached, p.hash);
    hash.add(p.averageReward);
  }
  const auto all = lives();
  if (!all) return all.error();
  for (const StoredLife& l : *all) {
    addAll(l.condition, l.life, l.qFunction, l.episodes, l.steps, l.falls, l.statesOutside, l.hash);
    addText(l.diverged);
    const auto rows = episodes(l.condition, l.life);
    if (!rows) return rows.error();
    for (const StoredEpisode& e : *rows) addAll(e.transitions, e.falls, e.ending), hash.add(e.reward);
    const auto own = measures(l.condition, l.life);
    if (!own) return own.error();
    for (const StoredMeasure& m : *own) addAll(m.episode), addText(m.name), hash.add(m.value);
  }
  return hash.value();
}

}  // namespace surefoot
