// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/store.h"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <filesystem>

#include "core/files/read_file.h"
#include "core/laboratory/store_database.h"
#include "core/version.h"

namespace surefoot {

namespace {

constexpr int kApplicationId = 0x53726674;  // "Srft"
constexpr int kFormat = 1;

/// Not in stores of the first days.
constexpr const char* kMeasures = R"(
CREATE TABLE IF NOT EXISTS measures (condition INTEGER NOT NULL, life INTEGER NOT NULL, episode INTEGER NOT NULL,
  name TEXT NOT NULL, value REAL NOT NULL, PRIMARY KEY (condition, life, episode, name)) WITHOUT ROWID;
)";

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

std::string hex(std::uint64_t value) {
  return fmt::format("{:016x}", value);
}
}  // namespace

Error plainError(const std::string& path, const SQLite::Exception& e) {
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

EndingCode endingCode(const EpisodeRow& row) {
  if (row.ending == Ending::Truncated) return EndingCode::Truncated;
  if (row.success) return EndingCode::Success;
  return row.falls > 0 ? EndingCode::Fall : EndingCode::End;
}

const char* endingName(EndingCode code) {
  constexpr const char* kNames[] = {"end", "success", "fall", "truncated"};
  return kNames[static_cast<int>(code) & 3];
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

namespace {

/// The tables of an empty store, with what is known of the plan.
void fill(SQLite::Database& db, const StoredPlan& plan) {
  SQLite::Transaction whole(db);
  db.exec(kSchema);
  db.exec(kMeasures);
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
}

}  // namespace

// Made under another name and then given its own, so that whoever finds it finds all of it.
Result<Store> Store::create(const std::string& path, const StoredPlan& plan) {
  const auto exists = fileError(path, "it exists already; name another file, or go on with --resume.");
  if (!missing(path)) return exists;
  const std::string meanwhile = fmt::format("{}.new-{}", path, getpid());
  const auto made = guarded<Done>(path, [&]() -> Status {
    SQLite::Database db(meanwhile, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    fill(db, plan);
    return Done{};
  });
  if (missing(path)) unlink(path.c_str());  // an empty file
  // What a store left that was killed and then removed would be replayed into this one.
  for (const char* rest : {"-wal", "-shm", "-journal"}) unlink((path + rest).c_str());
  const bool named = made && link(meanwhile.c_str(), path.c_str()) == 0;
  const int why = errno;
  unlink(meanwhile.c_str());
  if (!made) return made.error();
  if (!named)
    return why == EEXIST ? exists : fileError(path, fmt::format("it cannot be made: {}.", std::strerror(why)));
  return openToWrite(path);
}

Result<Store> Store::openAs(const std::string& path, bool write) {
  std::error_code failed;
  if (missing(path)) return fileError(path, "there is no such store.");
  if (!std::filesystem::is_regular_file(path, failed)) return fileError(path, "it is not a regular file.");
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
      db.exec(kMeasures);
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

std::vector<StoredMeasure> measuresToStore(const LifeResult& r) {
  std::vector<StoredMeasure> all;
  for (const NamedValue& m : measuresOf(r)) all.push_back({0, m.name, m.value});
  for (const GreedyTest& t : r.greedyTests) {
    all.push_back({t.episode, "transitions", static_cast<double>(t.steps)});
    all.push_back({t.episode, "reward", t.reward});
    all.push_back({t.episode, "falls", static_cast<double>(t.falls)});
    for (std::size_t m = 0; m < r.taskMeasures.size(); ++m)
      all.push_back({t.episode, r.taskMeasures[m].key, t.measures[m]});
  }
  return all;
}

Status Store::save(const StoredLife& life, const std::vector<StoredEpisode>& episodes,
                   const std::optional<StoredPreLearning>& before, const std::vector<StoredMeasure>& measures) {
  return guarded<Done>(path_, [&]() -> Status {
    Database& d = *database_;
    if (!d.addLife) {
      d.addLife = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO lives VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
      d.addEpisode = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO episodes VALUES (?, ?, ?, ?, ?, ?, ?)");
      d.addMeasure = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO measures VALUES (?, ?, ?, ?, ?)");
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
    for (const StoredMeasure& m : measures) {
      d.addMeasure->reset();
      SQLite::bind(*d.addMeasure, life.condition, life.life, m.episode, m.name, m.value);
      d.addMeasure->exec();
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
      if (db.execAndGet("SELECT count(*) FROM part.sqlite_master WHERE name = 'measures'").getInt() > 0)
        db.exec("INSERT INTO main.measures SELECT * FROM part.measures");
      whole.commit();
    }
    db.exec("DETACH part");
    return Done{};
  });
}

}  // namespace surefoot
