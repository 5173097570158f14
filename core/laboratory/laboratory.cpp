// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/laboratory.h"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <set>

#include "core/basics/version.h"
#include "core/files/read_file.h"
#include "core/laboratory/growing_plan.h"
#include "core/laboratory/kept_lives.h"
#include "core/laboratory/shared_q_function.h"
#include "core/laboratory/whole_life.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

/// One piece of work: a Q-function to learn, or a life to live.
struct Task {
  SharedQFunction* shared = nullptr;  // the Q-function that a life begins with
  int condition = -1, life = 0;
  std::string name{};  // the name under which it is kept
};

class Laboratory {
 public:
  Laboratory(const Registry& registry, const Plan& plan, Store& store, const LabOptions& options)
      : registry_(registry),
        plan_(plan),
        store_(store),
        options_(options),
        pool_(options.jobs, options.interrupted, options.paused),
        kept_(store.path()) {}

  Result<LabResult> run() {
    if (const Status s = planTasks(); !s) return s.error();
    meters_ = std::vector<Meter>(tasks_.size());
    const int before = result_.livesThere;
    const auto tick = [&] {
      LabProgress p{.work = sum(meters_), .livesThere = before, .livesPlanned = result_.livesPlanned, .falls = falls()};
      p.work.livesDone = livesDone_;
      if (options_.progress) options_.progress(p);
      const std::lock_guard lock(mutex_);
      static_cast<void>(static_cast<bool>(store_.settle()));  // if the disk is full, the next life reports it
      if (options_.look) options_.look(store_);
    };
    const Status s = pool_.run(
        static_cast<std::int64_t>(tasks_.size()), [&](std::int64_t i) { return work(i); }, tick);
    keepLessons();
    if (!s) return s.error();
    result_.livesThere += livesDone_;
    result_.livesKept = KeptLives::count(store_.path());
    return result_;
  }

 private:
  const Condition& conditionOf(const Task& task) const {
    return plan_.conditions[static_cast<std::size_t>(task.condition)];
  }

  /// First life 0 of all conditions, then life 1, …: conditions can be compared early, and a Q-function is freed soon.
  Status planTasks() {
    const auto there = store_.lives();
    if (!there) return there.error();
    std::set<std::pair<int, int>> done;
    for (const StoredLife& l : *there) done.emplace(l.condition, l.life), fallsThere_ += l.falls;
    std::vector<Task> lives;
    int most = plan_.lives;
    for (const int each : plan_.livesEach) most = std::max(most, each);
    for (int life = 0; life < most; ++life)
      for (int c = 0; c < static_cast<int>(plan_.conditions.size()); ++c) {
        if (life >= plan_.livesOf(static_cast<std::size_t>(c))) continue;
        if ((std::int64_t{c} * plan_.lives + life) % options_.shards != options_.shard - 1) continue;
        ++result_.livesPlanned;
        const Condition& condition = plan_.conditions[static_cast<std::size_t>(c)];
        if (done.contains({c, life}))
          ++result_.livesThere;
        else
          lives.push_back({qFunctionFor(condition, life), c, life, KeptLives::nameOf(condition, life)});
      }
    addLessons(std::move(lives));
    std::set<std::string> names;
    for (const Task& task : tasks_) names.insert(task.name);
    kept_.keepOnly(names);
    return Done{};
  }

  /// Adds each shared Q-function some lives before the first life that needs it, so that few lives wait, and only for
  /// those that are being learned. Kept lives need none.
  void addLessons(std::vector<Task> lives) {
    const std::size_t ahead = 2 * static_cast<std::size_t>(options_.jobs);
    std::set<const SharedQFunction*> added;
    std::size_t next = 0;
    for (std::size_t i = 0; i < lives.size(); ++i) {
      for (; next < lives.size() && next <= i + ahead; ++next)
        if (SharedQFunction* shared = lives[next].shared;
            shared && !kept_.has(lives[next].name) && added.insert(shared).second)
          tasks_.push_back({.shared = shared, .name = KeptLives::nameOf(shared->what, shared->number)});
      tasks_.push_back(lives[i]);
    }
  }

  SharedQFunction* qFunctionFor(const Condition& condition, int life) {
    if (!condition.preLearning) return nullptr;
    const int number = condition.preLearning->numberFor(life);
    auto& shared = shared_[{condition.preLearning->text, number}];
    if (!shared) shared = std::make_unique<SharedQFunction>(*condition.preLearning, number);
    shared->wanted();
    return shared.get();
  }

  Status work(std::int64_t i) {
    const Task& task = tasks_[static_cast<std::size_t>(i)];
    Meter& meter = meters_[static_cast<std::size_t>(i)];
    return task.condition < 0 ? learn(*task.shared, meter) : live(task, meter);
  }

  Status learn(SharedQFunction& shared, Meter& meter) {
    if (!shared.take()) return Done{};
    const std::string name = KeptLives::nameOf(shared.what, shared.number);
    const Configuration& c = shared.what.configuration;
    std::unique_ptr<Life> life;
    if (kept_.has(name)) {
      const auto file = kept_.read(name);
      const auto facts = file ? preLearningFrom(file->about.value("pre_learned", Json())) : std::nullopt;
      if (facts) return taught(shared, file, *facts, meter);
      life = takeUp(registry_, file, false);
    }
    if (!life) {
      auto made = makeLife(registry_, c, shared.number, false);
      if (!made) return made.error();
      life = std::move(*made);
      life->keepInputs();
    }
    liveOn(*life, meter, [&] { note(kept_.keep(name, checkpointOf(*life, c, false))); });
    if (!life->unanswered().empty() && !pool_.stopping()) return Error{life->unanswered(), ErrorKind::Unanswered};
    if (life->diverged()) return Error{"pre-learning: " + life->divergence(), ErrorKind::Diverged};
    if (!life->finished() || !life->unanswered().empty()) return Done{};
    const EpisodeLog& log = life->log();
    const bool reached = !c.until || log.averageReward() >= *c.until;
    return taught(shared, std::make_shared<const TensorFile>(qFileOf(*life, c)),
                  {.qFunction = shared.number,
                   .episodes = log.totals().episodes,
                   .falls = log.totals().falls,
                   .steps = life->steps(),
                   .averageReward = log.averageReward(),
                   .reached = reached,
                   .hash = life->hash()},
                  meter);
  }

  Status taught(SharedQFunction& shared, std::shared_ptr<const TensorFile> q, const StoredPreLearning& facts,
                Meter& meter) {
    shared.finish(std::move(q), facts);
    meter.done = true;
    const std::lock_guard lock(mutex_);
    result_.preLearningsAtCap += !facts.reached;
    return Done{};
  }

  /// Keeps learned Q-functions that are still needed, so that the next run need not learn them again.
  void keepLessons() {
    if (!pool_.stopping()) return;
    for (const auto& [key, shared] : shared_) {
      const auto q = shared->inHand();
      const std::string name = KeptLives::nameOf(shared->what, shared->number);
      if (!q || q->about.contains("pre_learned")) continue;  // it was kept before
      TensorFile file = *q;
      file.about["pre_learned"] = asJson(shared->facts());
      note(kept_.keep(name, std::move(file)));
    }
  }

  Status live(const Task& task, Meter& meter) {
    std::optional<StoredPreLearning> before;
    auto life = task.shared ? takeUpLearned(task, before) : takeUp(registry_, readKept(task), true);
    if (!life) {
      Configuration c = conditionOf(task).configuration;
      if (task.shared) {
        if (const Status s = learn(*task.shared, meter); !s) return s;  // unless another life learns it
        c.start = task.shared->wait(pool_);
        if (!c.start) return Done{};
        before = task.shared->facts();
      }
      auto made = makeLife(registry_, c, task.life, true);
      if (!made) return made.error();
      life = std::move(*made);
      life->keepInputs();
    }
    meter.done = false;
    if (before) before->condition = task.condition;
    const auto keep = [&] {
      TensorFile file = checkpointOf(*life, conditionOf(task).configuration, true);
      if (before) file.about["pre_learned"] = asJson(*before);
      note(kept_.keep(task.name, std::move(file)));
    };
    liveOn(*life, meter, keep);
    if (!life->unanswered().empty() && !pool_.stopping()) return Error{life->unanswered(), ErrorKind::Unanswered};
    if (!life->finished() || !life->unanswered().empty()) return Done{};
    if (const Status s = save(task, *life, before); !s) return keep(), s;
    kept_.drop(task.name);
    if (task.shared && task.shared->used()) kept_.drop(KeptLives::nameOf(task.shared->what, task.shared->number));
    meter.done = true;
    ++livesDone_;
    return Done{};
  }

  std::shared_ptr<const TensorFile> readKept(const Task& task) {
    return kept_.has(task.name) ? kept_.read(task.name) : nullptr;
  }

  /// A kept life, with the results of its pre-learning; nullptr: there is none.
  std::unique_ptr<Life> takeUpLearned(const Task& task, std::optional<StoredPreLearning>& before) {
    const auto file = readKept(task);
    if (file) before = preLearningFrom(file->about.value("pre_learned", Json()));
    return before ? takeUp(registry_, file, true) : nullptr;
  }

  void liveOn(Life& life, Meter& meter, const std::function<void()>& keep) {
    liveWhole(life, meter, pool_, std::chrono::duration<double>(options_.keepEvery), keep);
  }

  /// Notes the first reason why an unfinished life could not be kept.
  void note(const Status& kept) {
    const std::lock_guard lock(mutex_);
    if (!kept && result_.keeping) result_.keeping = kept;
  }

  /// Falls of all lives, without those of pre-learning.
  std::int64_t falls() const {
    std::int64_t all = fallsThere_;
    for (std::size_t i = 0; i < tasks_.size(); ++i)
      if (tasks_[i].condition >= 0) all += meters_[i].falls.load(std::memory_order_relaxed);
    return all;
  }

  Status save(const Task& task, const Life& life, const std::optional<StoredPreLearning>& before) {
    LifeResult r = summarise(life, task.life, 0.0);
    if (r.greedyTests.empty() && !life.diverged()) {
      const auto final = finalGreedy(registry_, conditionOf(task).configuration, life);
      if (!final) return final.error();
      r.final = *final;
    }
    StoredLife row{.condition = task.condition,
                   .life = task.life,
                   .qFunction = task.shared ? task.shared->number : -1,
                   .episodes = r.totals.episodes,
                   .steps = r.steps,
                   .falls = r.totals.falls,
                   .statesOutside = r.statesOutside,
                   .diverged = r.divergence,
                   .hash = r.hash,
                   .livesVersion = kLivesVersion,
                   .program = kVersion};
    std::vector<StoredEpisode> episodes;
    for (const EpisodeRow& e : r.rows) episodes.push_back({e.steps, e.reward, e.falls, endingCode(e)});
    const std::lock_guard lock(mutex_);
    return store_.save(row, episodes, before, measuresToStore(r));
  }

  const Registry& registry_;
  const Plan& plan_;
  Store& store_;
  const LabOptions& options_;
  WorkPool pool_;
  KeptLives kept_;
  std::map<std::pair<std::string, int>, std::unique_ptr<SharedQFunction>> shared_;
  std::vector<Task> tasks_;
  std::vector<Meter> meters_;
  std::atomic<int> livesDone_{0};
  std::int64_t fallsThere_ = 0;
  std::mutex mutex_;  // guards store_ and result_ while the pool runs
  LabResult result_;
};

}  // namespace

Result<LabResult> runPlan(const Registry& registry, const Plan& plan, Store& store, const LabOptions& options) {
  if (plan.growth && options.shards > 1)
    return Error{"--shard: lives whose number follows from the results cannot be shared out beforehand."};
  const auto live = [&](const Plan& fixed) { return Laboratory(registry, fixed, store, options).run(); };
  return plan.growth ? runGrowing(registry, plan, store, live) : live(plan);
}

}  // namespace surefoot
