// SPDX-License-Identifier: GPL-3.0-or-later
// For tests that write into a store what another version would have written: notes its checksums anew.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <cstdlib>

#include "core/store/store_checks.h"

namespace surefoot {

inline void sealStore(SQLite::Database& db) {
  std::uint64_t sum = 0;
  SQLite::Statement row(
      db,
      "SELECT condition, life, ifnull(q_function, -1), episodes, steps, falls, states_outside, "
      "ifnull(diverged, ''), hash, ifnull(lives_version, 0), ifnull(program, ''), checksum FROM lives");
  std::vector<std::pair<StoredLife, std::string>> lives;
  while (row.executeStep()) {
    const StoredLife l{.condition = row.getColumn(0),
                       .life = row.getColumn(1),
                       .qFunction = row.getColumn(2),
                       .episodes = row.getColumn(3).getInt64(),
                       .steps = row.getColumn(4).getInt64(),
                       .falls = row.getColumn(5).getInt64(),
                       .statesOutside = row.getColumn(6).getInt64(),
                       .diverged = row.getColumn(7),
                       .hash = std::strtoull(row.getColumn(8).getText(), nullptr, 16),
                       .livesVersion = row.getColumn(9),
                       .program = row.getColumn(10)};
    lives.emplace_back(l, hexText(checksumOf(l)) + row.getColumn(11).getString().substr(16));
    sum ^= checksumOf(l);
  }
  for (const auto& [l, text] : lives) {
    SQLite::Statement change(db, "UPDATE lives SET checksum = ? WHERE condition = ? AND life = ?");
    SQLite::bind(change, text, l.condition, l.life);
    change.exec();
  }
  const auto value = [&](const char* key) {
    return db.execAndGet(std::string("SELECT value FROM experiment WHERE key = '") + key + "'").getString();
  };
  StoredPlan plan{.title = value("title"),
                  .version = value("version"),
                  .seed = std::strtoull(value("seed").c_str(), nullptr, 10),
                  .paired = value("paired") == "1",
                  .shard = std::atoi(value("shard").c_str()),
                  .shards = std::atoi(value("shards").c_str()),
                  .conditions = {}};
  SQLite::Statement c(db,
                      "SELECT name, reference, text, configuration, lives, goal_reward, step_time FROM conditions "
                      "ORDER BY condition");
  while (c.executeStep())
    plan.conditions.push_back({c.getColumn(0), c.getColumn(1), c.getColumn(2), c.getColumn(3), c.getColumn(4).getInt(),
                               c.getColumn(5).getDouble(), c.getColumn(6).getDouble()});
  for (const auto& [key, text] :
       {std::pair{"lives_checksum", hexText(sum)}, {"plan_checksum", hexText(checksumOf(plan))}}) {
    SQLite::Statement change(db, "UPDATE experiment SET value = ? WHERE key = ?");
    SQLite::bind(change, text, key);
    change.exec();
  }
}

}  // namespace surefoot
