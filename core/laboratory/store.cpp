// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <filesystem>
#include <map>

#include "core/files/read_file.h"
#include "core/version.h"

namespace surefoot {

namespace {

constexpr int kApplicationId = 0x53726674;  // "Srft"
constexpr int kFormat = 1;

constexpr const char* kSchema = R"(
CREATE TABLE experiment (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE conditions (condition INTEGER PRIMARY KEY, name TEXT NOT NULL, reference TEXT NOT NULL, text TEXT NOT NULL, configuration TEXT NOT NULL,
  lives INTEGER NOT NULL, goal_reward REAL NOT NULL, step_time REAL NOT NULL);
CREATE TABLE pre_learned (condition INTEGER NOT NULL, q_function INTEGER NOT NULL, episodes INTEGER NOT NULL,
  falls INTEGER NOT NULL, steps INTEGER NOT NULL, average_reward REAL NOT NULL, reached INTEGER NOT NULL, hash TEXT NOT NULL,
  PRIMARY KEY (condition, q_function)) WITHOUT ROWID;
CREATE TABLE lives (condition INTEGER NOT NULL, life INTEGER NOT NULL, q_function INTEGER, episodes INTEGER NOT NULL,
  steps INTEGER NOT NULL, falls INTEGER NOT NULL, states_outside INTEGER NOT NULL, diverged TEXT, hash TEXT NOT NULL,
  PRIMARY KEY (condition, life)) WITHOUT ROWID;
CREATE TABLE episodes (condition INTEGER NOT NULL, life INTEGER NOT NULL, episode INTEGER NOT NULL,
  transitions INTEGER NOT NULL, reward REAL NOT NULL, falls INTEGER NOT NULL, ending INTEGER NOT NULL,
  PRIMARY KEY (condition, life, episode)) WITHOUT ROWID;
CREATE TABLE endings (ending INTEGER PRIMARY KEY, name TEXT NOT NULL);
INSERT INTO endings VALUES (0, 'end'), (1, 'success'), (2, 'fall'), (3, 'truncated');
)";

/// What SQLite says, in words that help.
Error plain(const std::string& path, const SQLite::Exception& e) {
  const auto say = [&](const char* sentence) { return fileError(path, sentence); };
  switch (e.getErrorCode()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return say("another process is using it; wait for it to end, or write to another file.");
    case SQLITE_FULL:
      return say("the disk is full; what was written before is kept, so make room and go on with --resume.");
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return say("it cannot be written to; look at its permissions and those of its folder.");
    case SQLITE_CANTOPEN:
      return say("it cannot be opened or made there; look at the folder and its permissions.");
    case SQLITE_NOTADB:
      return say("it is not a store of results (not an SQLite file).");
    case SQLITE_CORRUPT:
      return say("the file is damaged.");
    case SQLITE_IOERR:
      return say("it cannot be read or written; the disk may be full or damaged.");
    default:
      return fileError(path, fmt::format("{}.", e.what()));
  }
}

/// Calls f, and turns what SQLite throws into an error.
template <class T, class F>
Result<T> guarded(const std::string& path, F f) {
  try {
    return f();
  } catch (const SQLite::Exception& e) {
    return plain(path, e);
  }
}

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}
std::uint64_t fromHex(const std::string& text) {
  return std::strtoull(text.c_str(), nullptr, 16);
}

}  // namespace

struct Store::Database {
  Database(const std::string& path, int flags) : db(path, flags, 0), writes((flags & SQLite::OPEN_READWRITE) != 0) {}
  ~Database() {
    addLife.reset(), addEpisode.reset();
    // A file that can be read where nothing can be written. If it fails, the next who opens it will try again.
    if (writes) static_cast<void>(db.tryExec("PRAGMA journal_mode = DELETE"));
  }
  SQLite::Database db;
  bool writes;
  // Prepared once, because a life has a thousand episodes.
  std::unique_ptr<SQLite::Statement> addLife, addEpisode;
};

EndingCode endingCode(const EpisodeRow& row) {
  if (row.ending == Ending::Truncated) return EndingCode::Truncated;
  if (row.success) return EndingCode::Success;
  return row.falls > 0 ? EndingCode::Fall : EndingCode::End;
}

Store::Store(std::string path, std::unique_ptr<Database> database)
    : path_(std::move(path)),
      database_(std::move(database)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

bool Store::missing(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::symlink_status(path, error);
  if (!std::filesystem::exists(status)) return true;
  return std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) == 0;
}

Result<Store> Store::create(const std::string& path, const StoredPlan& plan) {
  if (!missing(path)) return fileError(path, "it exists already; name another file, or go on with --resume.");
  return guarded<Store>(path, [&]() -> Result<Store> {
    auto data = std::make_unique<Database>(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    SQLite::Database& db = data->db;
    db.exec("PRAGMA locking_mode = EXCLUSIVE; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
    SQLite::Transaction whole(db, SQLite::TransactionBehavior::EXCLUSIVE);
    db.exec(kSchema);
    db.exec(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplicationId, kFormat));
    SQLite::Statement pair(db, "INSERT INTO experiment VALUES (?, ?)");
    for (const auto& [key, value] : {std::pair<const char*, std::string>{"version", kVersion},
                                     {"title", plan.title},
                                     {"seed", std::to_string(plan.seed)},
                                     {"paired", plan.paired ? "1" : "0"},
                                     {"shard", std::to_string(plan.shard)},
                                     {"shards", std::to_string(plan.shards)}}) {
      SQLite::bind(pair, key, value);
      pair.exec();
      pair.reset();
    }
    SQLite::Statement row(db, "INSERT INTO conditions VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
      const StoredCondition& c = plan.conditions[i];
      SQLite::bind(row, static_cast<int>(i), c.name, c.reference, c.text, c.configuration, c.lives, c.goalReward,
                   c.stepTime);
      row.exec();
      row.reset();
    }
    whole.commit();
    return Store(path, std::move(data));
  });
}

Result<Store> Store::openAs(const std::string& path, bool write) {
  if (missing(path)) return fileError(path, "there is no such store.");
  return guarded<Store>(path, [&]() -> Result<Store> {
    auto data = std::make_unique<Database>(path, write ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY);
    SQLite::Database& db = data->db;
    if (write) db.exec("PRAGMA locking_mode = EXCLUSIVE");
    const int id = db.execAndGet("PRAGMA application_id").getInt();
    const int format = db.execAndGet("PRAGMA user_version").getInt();
    if (id != kApplicationId) return fileError(path, "it is not a store of results.");
    if (format != kFormat)
      return fileError(path, fmt::format("its format is {}, and this program reads format {}.", format, kFormat));
    if (write) {
      db.exec("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
      db.exec("BEGIN EXCLUSIVE; COMMIT");  // from now on the file is ours
    }
    return Store(path, std::move(data));
  });
}

Result<Store> Store::openToWrite(const std::string& path) {
  return openAs(path, true);
}
Result<Store> Store::open(const std::string& path) {
  return openAs(path, false);
}

Status Store::save(const StoredLife& life, const std::vector<StoredEpisode>& episodes,
                   const std::optional<StoredPreLearning>& before) {
  return guarded<Done>(path_, [&]() -> Status {
    Database& d = *database_;
    if (!d.addLife) {
      d.addLife = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO lives VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
      d.addEpisode = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO episodes VALUES (?, ?, ?, ?, ?, ?, ?)");
    }
    SQLite::Transaction whole(d.db);
    d.addLife->reset();
    SQLite::bind(*d.addLife, life.condition, life.life, life.qFunction, life.episodes, life.steps, life.falls,
                 life.statesOutside, life.diverged, hex(life.hash));
    if (life.qFunction < 0) d.addLife->bind(3);
    if (life.diverged.empty()) d.addLife->bind(8);
    d.addLife->exec();
    std::int64_t number = 0;
    for (const StoredEpisode& e : episodes) {
      d.addEpisode->reset();
      SQLite::bind(*d.addEpisode, life.condition, life.life, ++number, e.transitions, e.reward, e.falls,
                   static_cast<int>(e.ending));
      d.addEpisode->exec();
    }
    if (before) {
      SQLite::Statement row(d.db, "INSERT OR REPLACE INTO pre_learned VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
      SQLite::bind(row, before->condition, before->qFunction, before->episodes, before->falls, before->steps,
                   before->averageReward, before->reached ? 1 : 0, hex(before->hash));
      row.exec();
    }
    whole.commit();
    return Done{};
  });
}

Status Store::setLives(int lives) {
  return guarded<Done>(path_, [&]() -> Status {
    database_->db.exec(fmt::format("UPDATE conditions SET lives = {}", lives));
    return Done{};
  });
}

Status Store::add(const Store& part) {
  return guarded<Done>(path_, [&]() -> Status {
    SQLite::Database& db = database_->db;
    SQLite::Statement attach(db, "ATTACH ? AS part");
    SQLite::bind(attach, part.path());
    attach.exec();
    const std::string twice =
        db.execAndGet(
              "SELECT ifnull((SELECT c.name || ', life ' || l.life FROM part.lives AS l JOIN main.lives USING "
              "(condition, life) JOIN main.conditions AS c USING (condition) LIMIT 1), '')")
            .getString();
    if (!twice.empty()) {
      db.exec("DETACH part");
      return fileError(part.path(), fmt::format("it holds a life that another part holds, too: {}.", twice));
    }
    {
      SQLite::Transaction whole(db);
      db.exec(
          "INSERT OR IGNORE INTO main.pre_learned SELECT * FROM part.pre_learned; "
          "INSERT INTO main.lives SELECT * FROM part.lives; INSERT INTO main.episodes SELECT * FROM part.episodes");
      whole.commit();
    }
    db.exec("DETACH part");
    return Done{};
  });
}

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
    return plan;
  });
}

Result<std::vector<StoredLife>> Store::lives() const {
  return guarded<std::vector<StoredLife>>(path_, [&] {
    std::vector<StoredLife> lives;
    SQLite::Statement row(database_->db,
                          "SELECT condition, life, ifnull(q_function, -1), episodes, steps, falls, states_outside, "
                          "ifnull(diverged, ''), hash FROM lives ORDER BY condition, life");
    while (row.executeStep())
      lives.push_back({row.getColumn(0), row.getColumn(1), row.getColumn(2), row.getColumn(3).getInt64(),
                       row.getColumn(4).getInt64(), row.getColumn(5).getInt64(), row.getColumn(6).getInt64(),
                       row.getColumn(7), fromHex(row.getColumn(8))});
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

Result<std::uint64_t> Store::contentHash() const {
  Hash64 hash;
  const auto addText = [&](const std::string& text) {
    hash.add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
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
  }
  return hash.value();
}

}  // namespace surefoot
