// SPDX-License-Identifier: GPL-3.0-or-later
// The results of an experiment in one SQLite file. A life is written whole or not at all: however the program ends, the
// lives written before are kept, and `resume` does the rest. The file says nothing about wall-clock time, host, number
// of jobs or places of files. Used by one thread at a time. One process writes at a time (store_lock.h); any number of
// processes may read meanwhile.
//
//   experiment   key, value                  program version, title, seed, paired, shard; writing: 1 while it is open
//   conditions   condition, name, reference (its name), text, configuration (JSON), lives, goal_reward,
//                step_time
//   pre_learned  condition, q_function, episodes, falls, steps, average_reward, reached, hash, checksum
//   lives        condition, life, q_function, episodes, steps, falls, states_outside, diverged, hash,
//                lives_version (lives_version.h) and program of whoever lived it, checksum
//   episodes     condition, life, episode, transitions, reward, falls, ending
//   measures     condition, life, episode, name, value    episode 0: of the life (measuresOf); else of the greedy test
//                                                         behind that episode
//   q_functions  content, file               that lives of the plan begin with, by the hash of their values
//   endings      ending, name                0 end, 1 success, 2 fall, 3 truncated
//
// Everything that is read is checked: types, ranges and checksums (store_checks.h). The checksums of the plan and of
// the list of lives are in experiment, under plan_checksum and lives_checksum. Stores of format 1 have no checksums and
// no q_functions, and do not say which program lived a life; when one is continued, checksums of its content are added.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/experiment/experiment.h"
#include "core/plans/plan.h"

namespace surefoot {

class StoreLock;
class TemporaryFolder;

enum class EndingCode : int { End, Success, Fall, Truncated };
EndingCode endingCode(const EpisodeRow& row);
/// "success", "fall", …
const char* endingName(EndingCode code);

/// One condition as the store holds it.
struct StoredCondition {
  std::string name, reference, text;
  std::string configuration;  ///< JSON
  int lives = 0;              ///< planned
  double goalReward = 0.0;    ///< highest reward of an episode
  double stepTime = 0.0;      ///< [s]; 0: no clock
};

struct StoredPlan {
  std::string title, version;
  std::uint64_t seed = 0;
  bool paired = false;
  int shard = 1, shards = 1;  ///< this store holds part `shard` of `shards`
  std::vector<StoredCondition> conditions;
  std::string growth{};  ///< JSON (growthAsJson); empty: all conditions have a fixed number of lives
  /// Q-functions that lives begin with, by their content (q_file.h). Used to make a store; Store::plan() omits them.
  std::map<std::string, std::shared_ptr<const TensorFile>> qFunctions{};
};

/// A measure of a life, or of the greedy test behind one of its episodes.
struct StoredMeasure {
  std::int64_t episode = 0;  ///< 0: a measure of the whole life
  std::string name;
  double value = 0.0;
};
/// The measures of a life that a store keeps besides its episodes.
std::vector<StoredMeasure> measuresToStore(const LifeResult& result);

/// A life without its episodes.
struct StoredLife {
  int condition = 0, life = 0;
  int qFunction = -1;  ///< its number in the pool; -1: none
  std::int64_t episodes = 0, steps = 0, falls = 0, statesOutside = 0;
  std::string diverged;
  std::uint64_t hash = 0;
  int livesVersion = 0;   ///< 0: not noted
  std::string program{};  ///< its version; empty: not noted
};

struct StoredEpisode {
  std::int64_t transitions = 0;
  double reward = 0.0;
  int falls = 0;
  EndingCode ending = EndingCode::End;
};

/// A Q-function that lives of a condition began with.
struct StoredPreLearning {
  int condition = 0, qFunction = 0;
  std::int64_t episodes = 0, falls = 0, steps = 0;
  double averageReward = 0.0;
  bool reached = false;  ///< it reached the reward that was asked for; else it ended at the cap
  std::uint64_t hash = 0;
};

class Store {
 public:
  /// A new file; refused if there is one of this name.
  static Result<Store> create(const std::string& path, const StoredPlan& plan);
  /// To go on writing.
  static Result<Store> openToWrite(const std::string& path, const std::atomic<bool>* interrupted = nullptr);
  /// To read, also while a process writes and where nothing can be written. It must have our tables and no others.
  /// Opening and reading end soon after `interrupted` is set.
  static Result<Store> open(const std::string& path, const std::atomic<bool>* interrupted = nullptr);
  /// To read while another process writes, and leave no trace: a copy of one moment is read, from the folder for
  /// temporary files. No lock is taken, no file is made or touched beside the store. A store that changes faster than
  /// it can be copied is refused; a later try may succeed.
  static Result<Store> peek(const std::string& path, const std::atomic<bool>* interrupted = nullptr);
  /// There is no file, or an empty one.
  static bool missing(const std::string& path);

  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  /// Writes a life with all that belongs to it, or nothing.
  Status save(const StoredLife& life, const std::vector<StoredEpisode>& episodes,
              const std::optional<StoredPreLearning>& before, const std::vector<StoredMeasure>& measures = {});
  /// Takes everything over from another store of the same plan.
  Status add(const Store& part);
  /// More lives than were planned at first.
  Status setLives(int lives);
  Status setLives(const std::vector<int>& lives);  ///< of every condition
  /// Moves the lives saved since the last call from the log into the file itself, which is then complete without it.
  Status settle();

  Result<StoredPlan> plan() const;
  /// Ordered by condition and life.
  Result<std::vector<StoredLife>> lives() const;
  Result<std::vector<StoredPreLearning>> preLearned() const;
  Result<std::vector<StoredEpisode>> episodes(int condition, int life) const;
  /// Ordered by episode and name.
  Result<std::vector<StoredMeasure>> measures(int condition, int life) const;
  /// The Q-function with this content, with which lives begin; nullptr: the store has none.
  Result<std::shared_ptr<const TensorFile>> qFunction(const std::string& content) const;
  /// A warning for the reader of the results: lives may be missing. Usually empty.
  std::string note() const;
  /// A hash of everything but the shard and the versions of program and lives, ordered by condition, life and episode.
  Result<std::uint64_t> contentHash() const;

  const std::string& path() const { return path_; }

 private:
  struct Database;
  Store(std::string path, std::unique_ptr<Database> database);
  static Result<Store> openLocked(const std::string& path, StoreLock lock, const std::atomic<bool>* interrupted);
  /// Reads what is at `uri`. `alone`: nobody writes the store now, and it has no log.
  static Result<Store> openAt(const std::string& path, const std::string& uri, TemporaryFolder folder, bool alone,
                              const std::atomic<bool>* interrupted);
  std::string path_;
  std::unique_ptr<Database> database_;
};

/// A plan in the form in which a store keeps it.
Result<StoredPlan> planToStore(const Registry& registry, const Plan& plan);

/// The plan of a store's lives, made from the store alone: to go on without the plan's file.
Result<Plan> planFromStore(const Registry& registry, const Store& store);
/// How many lives a store of this plan is to hold: all lives, or those of its shard.
int livesPlanned(const StoredPlan& plan);

/// Whether lives of this program may be added to the lives of a store. The error says why not: another program lived
/// them, which makes other lives (lives_version.h).
Status checkLivesVersion(const std::vector<StoredLife>& lives, const std::string& path);

/// Whether store and plan agree, but for the number of lives. The error names the first difference, with both values.
Status checkSamePlan(const StoredPlan& stored, const StoredPlan& plan, const std::string& path);
/// Whether the store holds the same shard of the plan.
Status checkSameShard(const StoredPlan& stored, const StoredPlan& plan, const std::string& path);

}  // namespace surefoot
