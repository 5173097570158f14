// SPDX-License-Identifier: GPL-3.0-or-later
// The results of an experiment in one SQLite file. A life is written whole or not at all, so that whatever ends the
// program, everything before is kept and `resume` does the rest. Nothing in it tells of wall-clock time, host, number
// of jobs, or where files lie. Used by one thread at a time. One process writes at a time (store_lock.h); any number
// read meanwhile.
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
// What is read is checked: types, ranges, and the checksums (store_checks.h), of the plan and of the list of lives
// under plan_checksum and lives_checksum in experiment. Stores of format 1 have neither checksums nor q_functions nor
// who lived a life; going on with one notes checksums of what is there.
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
  /// That lives begin with, by their content (q_file.h). For a store that is made; Store::plan() leaves them there.
  std::map<std::string, std::shared_ptr<const TensorFile>> qFunctions{};
};

/// Of a life, or of the greedy test behind an episode of it.
struct StoredMeasure {
  std::int64_t episode = 0;  ///< 0: of the life
  std::string name;
  double value = 0.0;
};
/// What a store keeps of a life besides its episodes.
std::vector<StoredMeasure> measuresToStore(const LifeResult& result);

/// A life without its episodes.
struct StoredLife {
  int condition = 0, life = 0;
  int qFunction = -1;  ///< of its pool; -1: none
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
  bool reached = false;  ///< the reward that was asked for; else it ended at the cap
  std::uint64_t hash = 0;
};

class Store {
 public:
  /// A new file; refused if there is one of this name.
  static Result<Store> create(const std::string& path, const StoredPlan& plan);
  /// To go on writing.
  static Result<Store> openToWrite(const std::string& path, const std::atomic<bool>* interrupted = nullptr);
  /// To read, whoever writes meanwhile, and where nothing can be written. Its tables must be ours and no others.
  /// Opening and reading end soon after `interrupted` is set.
  static Result<Store> open(const std::string& path, const std::atomic<bool>* interrupted = nullptr);
  /// Nothing is there, or nothing was begun.
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
  /// Puts what was saved since the last time into the file itself, so that it is found without the log beside it.
  Status settle();

  Result<StoredPlan> plan() const;
  /// Ordered by condition and life.
  Result<std::vector<StoredLife>> lives() const;
  Result<std::vector<StoredPreLearning>> preLearned() const;
  Result<std::vector<StoredEpisode>> episodes(int condition, int life) const;
  /// Ordered by episode and name.
  Result<std::vector<StoredMeasure>> measures(int condition, int life) const;
  /// That lives begin with; nullptr: it holds none of this content.
  Result<std::shared_ptr<const TensorFile>> qFunction(const std::string& content) const;
  /// A sentence that whoever looks at the results should read: lives may be missing. Usually empty.
  std::string note() const;
  /// Over everything but the shard and the versions of program and lives, ordered by condition, life and episode.
  Result<std::uint64_t> contentHash() const;

  const std::string& path() const { return path_; }

 private:
  struct Database;
  Store(std::string path, std::unique_ptr<Database> database);
  static Result<Store> openLocked(const std::string& path, StoreLock lock, const std::atomic<bool>* interrupted);
  std::string path_;
  std::unique_ptr<Database> database_;
};

/// What the store keeps of a plan.
Result<StoredPlan> planToStore(const Registry& registry, const Plan& plan);

/// The plan whose lives a store holds, from what the store keeps of it: to go on without the plan's file.
Result<Plan> planFromStore(const Registry& registry, const Store& store);
/// Lives that a store of this plan is to hold: of all, or of its shard.
int livesPlanned(const StoredPlan& plan);

/// Whether lives of this program may stand beside those of a store: why not, if these were lived by a program whose
/// lives are others (lives_version.h).
Status checkLivesVersion(const std::vector<StoredLife>& lives, const std::string& path);

/// Whether a store belongs to a plan: the first difference, with both values. The number of lives may be another.
Status checkSamePlan(const StoredPlan& stored, const StoredPlan& plan, const std::string& path);
/// Whether it holds the same part of it.
Status checkSameShard(const StoredPlan& stored, const StoredPlan& plan, const std::string& path);

}  // namespace surefoot
