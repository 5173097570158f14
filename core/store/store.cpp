// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/store.h"

#include <fmt/format.h>

#include <map>

#include "core/files/read_file.h"
#include "core/life/lives_version.h"
#include "core/store/store_database.h"

namespace surefoot {

namespace {

constexpr const char* kAddLife =
    "INSERT INTO lives (condition, life, q_function, episodes, steps, falls, states_outside, diverged, hash, "
    "lives_version, program, checksum) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

}  // namespace

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
      d.addLife = std::make_unique<SQLite::Statement>(d.db, kAddLife);
      d.addEpisode = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO episodes VALUES (?, ?, ?, ?, ?, ?, ?)");
      d.addMeasure = std::make_unique<SQLite::Statement>(d.db, "INSERT INTO measures VALUES (?, ?, ?, ?, ?)");
    }
    SQLite::Transaction whole(d.db);
    const std::uint64_t own = checksumOf(life);
    d.addLife->reset();
    SQLite::bind(*d.addLife, life.condition, life.life, life.qFunction, life.episodes, life.steps, life.falls,
                 life.statesOutside, life.diverged, hexText(life.hash), life.livesVersion, life.program,
                 checksumText(own, checksumOf(episodes), checksumOf(measures)));
    if (life.qFunction < 0) d.addLife->bind(3);
    if (life.diverged.empty()) d.addLife->bind(8);
    if (life.livesVersion == kLivesVersionUnknown) d.addLife->bind(10);
    if (life.program.empty()) d.addLife->bind(11);
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
      SQLite::Statement row(d.db, "INSERT OR REPLACE INTO pre_learned VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
      SQLite::bind(row, before->condition, before->qFunction, before->episodes, before->falls, before->steps,
                   before->averageReward, before->reached ? 1 : 0, hexText(before->hash), hexText(checksumOf(*before)));
      row.exec();
    }
    d.setValue(kLivesSum, hexText(d.livesSum ^ own));
    whole.commit();
    d.livesSum ^= own;
    d.unsettled = true;
    return Done{};
  });
}

Status Store::settle() {
  return guarded<Done>(path_, [&]() -> Status {
    if (std::exchange(database_->unsettled, false)) database_->db.exec("PRAGMA wal_checkpoint(PASSIVE)");
    return Done{};
  });
}

std::string Store::note() const {
  return database_->note;
}

Status Store::setLives(int lives) {
  const auto now = plan();
  return now ? setLives(std::vector<int>(now->conditions.size(), lives)) : now.error();
}

Status Store::setLives(const std::vector<int>& lives) {
  return guarded<Done>(path_, [&]() -> Status {
    SQLite::Transaction whole(database_->db);
    StoredPlan now = database_->readPlan();
    for (std::size_t i = 0; i < now.conditions.size(); ++i) {
      now.conditions[i].lives = lives[i];
      database_->db.exec(fmt::format("UPDATE conditions SET lives = {} WHERE condition = {}", lives[i], i));
    }
    database_->setValue(kPlanSum, hexText(checksumOf(now)));
    whole.commit();
    return Done{};
  });
}

Status Store::add(const Store& part) {
  const auto plan = part.plan();
  const auto here = lives(), there = part.lives();
  const auto learned = part.preLearned();
  if (!plan || !here || !there || !learned)
    return !plan ? plan.error() : !here ? here.error() : !there ? there.error() : learned.error();
  std::set<std::pair<int, int>> mine;
  for (const StoredLife& l : *here) mine.emplace(l.condition, l.life);
  std::map<std::pair<int, int>, StoredPreLearning> facts;
  for (const StoredPreLearning& p : *learned) facts[{p.condition, p.qFunction}] = p;
  for (const StoredLife& l : *there)
    if (mine.contains({l.condition, l.life})) {
      const auto c = static_cast<std::size_t>(l.condition);
      return fileError(part.path(), fmt::format("it holds a life that another part holds, too: {}, life {}.",
                                                c < plan->conditions.size() ? plan->conditions[c].name : "?", l.life));
    }
  for (const StoredLife& l : *there) {
    const auto rows = part.episodes(l.condition, l.life);
    if (!rows) return rows.error();
    const auto own = part.measures(l.condition, l.life);
    if (!own) return own.error();
    const auto before = facts.find({l.condition, l.qFunction});
    const auto fact = before == facts.end() ? std::nullopt : std::optional(before->second);
    if (const Status s = save(l, *rows, fact, *own); !s) return s;
  }
  return Done{};
}

}  // namespace surefoot
