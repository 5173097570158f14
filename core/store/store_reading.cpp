// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "core/files/limited_json.h"
#include "core/files/read_file.h"
#include "core/saved/q_file.h"
#include "core/store/store_database.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr int kMostNumber = 1'000'000;           // largest number of a condition, a life or a Q-function
constexpr std::size_t kLongestName = 10'000;     // [bytes]
constexpr std::size_t kLongestText = 16u << 20;  // [bytes]

std::uint64_t numberOf(const std::string& text, std::uint64_t low, std::uint64_t high, const char* key) {
  std::uint64_t number = 0;
  const auto [last, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc{} || last != text.data() + text.size() || number < low || number > high)
    throw Damaged(fmt::format("in its table experiment {} is \"{}\"", key, shortened(text)));
  return number;
}

/// Checks the keys of a configuration that findings and window read.
void checkConfiguration(const std::string& text) {
  const auto json = parseJson(text);
  if (!json.is_object()) throw Damaged("a condition has no configuration");
  for (const char* key : {"environment", "preset", "scenario", "agent", "features", "policy"})
    if (json.contains(key) && !json[key].is_string())
      throw Damaged(fmt::format("in the configuration of a condition {} is no name", key));
}

StoredLife lifeOf(const CheckedRow& row, bool noted) {
  return {.condition = row.number(0, 0, kMostNumber),
          .life = row.number(1, 0, kMostNumber),
          .qFunction = row.isNull(2) ? -1 : row.number(2, 0, kMostNumber),
          .episodes = row.whole(3, 0, kMostLifeSteps),
          .steps = row.whole(4, 0, kMostLifeSteps),
          .falls = row.whole(5, 0, kMostLifeSteps),
          .statesOutside = row.whole(6, 0, std::numeric_limits<std::int64_t>::max()),
          .diverged = row.isNull(7) ? "" : row.text(7),
          .hash = row.hash(8),
          .livesVersion = !noted || row.isNull(9) ? 0 : row.number(9, 0, kMostNumber),
          .program = !noted || row.isNull(10) ? "" : row.text(10, kLongestName)};
}

constexpr const char *kLifeColumns =
                         "SELECT condition, life, q_function, episodes, steps, falls, states_outside, "
                         "diverged, hash",
                     *kNotedColumns = ", lives_version, program, checksum";

std::string nameOf(const StoredLife& life) {
  return fmt::format("life {} of condition {}", life.life, life.condition + 1);
}

/// Calls f on the database within one transaction, so that everything it reads is from one moment.
template <class T, class F>
Result<T> reading(const std::string& path, SQLite::Database& db, F f) {
  return guarded<T>(path, [&]() -> Result<T> {
    SQLite::Transaction moment(db);
    T read = f();
    moment.commit();
    return read;
  });
}

}  // namespace

StoredPlan Store::Database::readPlan() {
  StoredPlan plan;
  plan.version = valueOf("version"), plan.title = valueOf("title");
  plan.seed = numberOf(valueOf("seed"), 0, std::numeric_limits<std::uint64_t>::max(), "seed");
  plan.paired = numberOf(valueOf("paired"), 0, 1, "paired") == 1;
  plan.shards = static_cast<int>(numberOf(valueOf("shards"), 1, kMostNumber, "shards"));
  plan.shard = static_cast<int>(numberOf(valueOf("shard"), 1, static_cast<std::uint64_t>(plan.shards), "shard"));
  plan.growth = valueOf(kGrowth);
  SQLite::Statement statement(db,
                              "SELECT name, reference, text, configuration, lives, goal_reward, step_time, "
                              "condition FROM conditions ORDER BY condition");
  const CheckedRow row(statement, "conditions");
  while (statement.executeStep()) {
    const int next = static_cast<int>(plan.conditions.size());
    row.whole(7, next, next);
    plan.conditions.push_back({row.text(0, kLongestName), row.text(1, kLongestName), row.text(2, kLongestText),
                               row.text(3, kLongestText), row.number(4, 1, kMostNumber), row.real(5), row.real(6)});
    if (plan.conditions.back().stepTime < 0) throw Damaged("in its table conditions step_time is negative");
    checkConfiguration(plan.conditions.back().configuration);
  }
  if (plan.conditions.empty()) throw Damaged("it holds no condition");
  if (format() > kOldestFormat && valueOf(kPlanSum) != hexText(checksumOf(plan)))
    throw Damaged("its plan is not what was written");
  return plan;
}

std::vector<StoredLife> Store::Database::readLives() {
  const bool noted = format() > kOldestFormat;
  const int conditions = db.execAndGet("SELECT count(*) FROM conditions").getInt();
  std::vector<StoredLife> lives;
  SQLite::Statement statement(
      db, std::string(kLifeColumns) + (noted ? kNotedColumns : "") + " FROM lives ORDER BY condition, life");
  const CheckedRow row(statement, "lives");
  std::uint64_t sum = 0;
  while (statement.executeStep()) {
    row.whole(0, 0, conditions - 1);
    lives.push_back(lifeOf(row, noted));
    if (!noted) continue;
    const std::uint64_t own = checksumOf(lives.back());
    compareChecksum(row.text(11), ChecksumPart::Life, own, nameOf(lives.back()));
    sum ^= own;
  }
  if (noted && valueOf(kLivesSum) != hexText(sum))
    throw Damaged("lives are missing, or are not those that were written");
  return lives;
}

std::optional<std::pair<StoredLife, std::string>> Store::Database::readLife(int condition, int life) {
  const bool noted = format() > kOldestFormat;
  SQLite::Statement statement(
      db, std::string(kLifeColumns) + (noted ? kNotedColumns : "") + " FROM lives WHERE condition = ? AND life = ?");
  SQLite::bind(statement, condition, life);
  if (!statement.executeStep()) return std::nullopt;
  const CheckedRow row(statement, "lives");
  return std::pair(lifeOf(row, noted), noted ? row.text(11) : "");
}

std::vector<StoredPreLearning> Store::Database::readPreLearned() {
  std::vector<StoredPreLearning> all;
  const bool noted = format() > kOldestFormat;
  SQLite::Statement statement(db, std::string("SELECT condition, q_function, episodes, falls, steps, average_reward, "
                                              "reached, hash") +
                                      (noted ? ", checksum" : "") + " FROM pre_learned ORDER BY condition, q_function");
  const CheckedRow row(statement, "pre_learned");
  while (statement.executeStep()) {
    all.push_back({row.number(0, 0, kMostNumber), row.number(1, 0, kMostNumber), row.whole(2, 0, kMostLifeSteps),
                   row.whole(3, 0, kMostLifeSteps), row.whole(4, 0, kMostLifeSteps), row.real(5),
                   row.whole(6, 0, 1) == 1, row.hash(7)});
    if (noted)
      compareChecksum(row.text(8), ChecksumPart::Life, checksumOf(all.back()), "what was learned before a life");
  }
  return all;
}

std::vector<StoredEpisode> Store::Database::readEpisodes(const StoredLife& life) {
  std::vector<StoredEpisode> episodes;
  SQLite::Statement statement(db,
                              "SELECT transitions, reward, falls, ending, episode FROM episodes WHERE condition = ? "
                              "AND life = ? ORDER BY episode");
  SQLite::bind(statement, life.condition, life.life);
  const CheckedRow row(statement, "episodes");
  while (statement.executeStep()) {
    const auto next = static_cast<std::int64_t>(episodes.size()) + 1;
    row.whole(4, next, next);
    episodes.push_back({row.whole(0, 0, kMostLifeSteps), row.real(1), row.number(2, 0, std::numeric_limits<int>::max()),
                        static_cast<EndingCode>(row.number(3, 0, 3))});
  }
  checkEpisodes(life, episodes);
  return episodes;
}

std::vector<StoredMeasure> Store::Database::readMeasures(int condition, int life) {
  std::vector<StoredMeasure> measures;
  if (!db.tableExists("measures")) return measures;
  SQLite::Statement statement(db,
                              "SELECT episode, name, value FROM measures WHERE condition = ? AND life = ? ORDER BY "
                              "episode, name");
  SQLite::bind(statement, condition, life);
  const CheckedRow row(statement, "measures");
  while (statement.executeStep())
    measures.push_back({row.whole(0, 0, kMostLifeSteps), row.text(1, kLongestName), row.real(2)});
  return measures;
}

Result<StoredPlan> Store::plan() const {
  return reading<StoredPlan>(path_, database_->db, [&] { return database_->readPlan(); });
}

Result<std::vector<StoredLife>> Store::lives() const {
  return reading<std::vector<StoredLife>>(path_, database_->db, [&] { return database_->readLives(); });
}

Result<std::vector<StoredPreLearning>> Store::preLearned() const {
  return reading<std::vector<StoredPreLearning>>(path_, database_->db, [&] { return database_->readPreLearned(); });
}

Result<std::vector<StoredEpisode>> Store::episodes(int condition, int life) const {
  return reading<std::vector<StoredEpisode>>(path_, database_->db, [&] {
    const auto row = database_->readLife(condition, life);
    if (!row) return std::vector<StoredEpisode>();
    auto episodes = database_->readEpisodes(row->first);
    if (!row->second.empty())
      compareChecksum(row->second, ChecksumPart::Episodes, checksumOf(episodes), nameOf(row->first));
    return episodes;
  });
}

Result<std::vector<StoredMeasure>> Store::measures(int condition, int life) const {
  return reading<std::vector<StoredMeasure>>(path_, database_->db, [&] {
    const auto row = database_->readLife(condition, life);
    if (!row) return std::vector<StoredMeasure>();
    auto measures = database_->readMeasures(condition, life);
    if (!row->second.empty())
      compareChecksum(row->second, ChecksumPart::Measures, checksumOf(measures), nameOf(row->first));
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
  if (!stored->growth.empty()) addText(stored->growth);
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
