// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/laboratory.h"

#include <fmt/format.h>

#include <condition_variable>
#include <map>
#include <mutex>
#include <set>

#include "core/experiment/q_file.h"
#include "core/files/read_file.h"

namespace surefoot {

namespace {

/// A Q-function that lives wait for.
class Lesson {
 public:
  Lesson(const PreLearning& preLearning, int qFunction) : what(preLearning), number(qFunction) {}

  const PreLearning& what;
  const int number;
  std::atomic<int> uses{0};  // lives that still need it

  void finish(std::shared_ptr<const TensorFile> q, const StoredPreLearning& facts) {
    const std::lock_guard lock(mutex_);
    q_ = std::move(q);
    facts_ = facts;
    done_.notify_all();
  }
  /// nullptr: the pool stopped before it was learned.
  std::shared_ptr<const TensorFile> wait(const WorkPool& pool) {
    std::unique_lock lock(mutex_);
    while (!q_ && !pool.stopping()) done_.wait_for(lock, std::chrono::milliseconds(50));
    return q_;
  }
  const StoredPreLearning& facts() const { return facts_; }
  void used() {
    if (--uses > 0) return;
    const std::lock_guard lock(mutex_);
    q_.reset();  // a few megabytes, of LEO a hundred
  }

 private:
  std::mutex mutex_;
  std::condition_variable done_;
  std::shared_ptr<const TensorFile> q_;
  StoredPreLearning facts_;
};

/// One piece of work: a lesson to learn, or a life to live.
struct Task {
  Lesson* lesson = nullptr;  // of a life: what it begins with
  int condition = -1, life = 0;
};

class Laboratory {
 public:
  Laboratory(const Registry& registry, const Plan& plan, Store& store, const LabOptions& options)
      : registry_(registry),
        plan_(plan),
        store_(store),
        options_(options),
        pool_(options.jobs, options.interrupted) {}

  Result<LabResult> run() {
    if (const Status s = planTasks(); !s) return s.error();
    meters_ = std::vector<Meter>(tasks_.size());
    const int before = result_.livesThere;
    const auto tick = [&] {
      LabProgress p{.work = sum(meters_), .livesThere = before, .livesPlanned = result_.livesPlanned};
      p.work.livesDone = livesDone_;
      options_.progress(p);
      if (!options_.look) return;
      const std::lock_guard lock(mutex_);
      options_.look(store_);
    };
    const Status s = pool_.run(
        static_cast<std::int64_t>(tasks_.size()), [&](std::int64_t i) { return work(i); },
        options_.progress ? tick : std::function<void()>{});
    if (!s) return s.error();
    result_.livesThere += livesDone_;
    return result_;
  }

 private:
  /// Life by life over all conditions: these can be compared early, and a Q-function is soon done with.
  Status planTasks() {
    const auto there = store_.lives();
    if (!there) return there.error();
    std::set<std::pair<int, int>> done;
    for (const StoredLife& l : *there) done.emplace(l.condition, l.life);
    std::vector<Task> lives;
    for (int life = 0; life < plan_.lives; ++life)
      for (int c = 0; c < static_cast<int>(plan_.conditions.size()); ++c) {
        if ((std::int64_t{c} * plan_.lives + life) % options_.shards != options_.shard - 1) continue;
        ++result_.livesPlanned;
        if (done.contains({c, life}))
          ++result_.livesThere;
        else
          lives.push_back({lessonFor(plan_.conditions[static_cast<std::size_t>(c)], life), c, life});
      }
    addLessons(std::move(lives));
    return Done{};
  }

  /// Lessons stand some lives before the first that needs them, so that few wait, and those for work in hand.
  void addLessons(std::vector<Task> lives) {
    const std::size_t ahead = 2 * static_cast<std::size_t>(options_.jobs);
    std::set<const Lesson*> added;
    std::size_t next = 0;
    for (std::size_t i = 0; i < lives.size(); ++i) {
      for (; next < lives.size() && next <= i + ahead; ++next)
        if (Lesson* lesson = lives[next].lesson; lesson && added.insert(lesson).second)
          tasks_.push_back({.lesson = lesson});
      tasks_.push_back(lives[i]);
    }
  }

  Lesson* lessonFor(const Condition& condition, int life) {
    if (!condition.preLearning) return nullptr;
    const int number = condition.preLearning->numberFor(life);
    auto& lesson = lessons_[{condition.preLearning->text, number}];
    if (!lesson) lesson = std::make_unique<Lesson>(*condition.preLearning, number);
    ++lesson->uses;
    return lesson.get();
  }

  Status work(std::int64_t i) {
    const Task& task = tasks_[static_cast<std::size_t>(i)];
    Meter& meter = meters_[static_cast<std::size_t>(i)];
    return task.condition < 0 ? learn(*task.lesson, meter) : live(task, meter);
  }

  Status learn(Lesson& lesson, Meter& meter) {
    const Configuration& c = lesson.what.configuration;
    auto life = makeLife(registry_, c, lesson.number, false);
    if (!life) return life.error();
    surefoot::live(**life, kNever, pool_, meter);
    if ((*life)->diverged()) return Error{"pre-learning: " + (*life)->divergence(), ErrorKind::Diverged};
    if (!(*life)->finished()) return Done{};
    const EpisodeLog& log = (*life)->log();
    const bool reached = !c.until || log.averageReward() >= *c.until;
    lesson.finish(std::make_shared<const TensorFile>(qFileOf(**life, c)), {.qFunction = lesson.number,
                                                                           .episodes = log.totals().episodes,
                                                                           .falls = log.totals().falls,
                                                                           .steps = (*life)->steps(),
                                                                           .averageReward = log.averageReward(),
                                                                           .reached = reached,
                                                                           .hash = (*life)->hash()});
    meter.done = true;
    const std::lock_guard lock(mutex_);
    result_.preLearningsAtCap += !reached;
    return Done{};
  }

  Status live(const Task& task, Meter& meter) {
    Configuration c = plan_.conditions[static_cast<std::size_t>(task.condition)].configuration;
    if (task.lesson) {
      c.start = task.lesson->wait(pool_);
      if (!c.start) return Done{};
    }
    auto life = makeLife(registry_, c, task.life, true);
    if (!life) return life.error();
    c.start.reset();
    surefoot::live(**life, kNever, pool_, meter);
    if (!(*life)->finished()) return Done{};
    if (const Status s = save(task, **life); !s) return s;
    if (task.lesson) task.lesson->used();
    meter.done = true;
    ++livesDone_;
    return Done{};
  }

  Status save(const Task& task, const Life& life) {
    const LifeResult r = summarise(life, task.life, 0.0);
    StoredLife row{.condition = task.condition,
                   .life = task.life,
                   .qFunction = task.lesson ? task.lesson->number : -1,
                   .episodes = r.totals.episodes,
                   .steps = r.steps,
                   .falls = r.totals.falls,
                   .statesOutside = r.statesOutside,
                   .diverged = r.divergence,
                   .hash = r.hash};
    std::vector<StoredEpisode> episodes;
    for (const EpisodeRow& e : r.rows) episodes.push_back({e.steps, e.reward, e.falls, endingCode(e)});
    std::optional<StoredPreLearning> before;
    if (task.lesson) {
      before = task.lesson->facts();
      before->condition = task.condition;
    }
    const std::lock_guard lock(mutex_);
    return store_.save(row, episodes, before, measuresToStore(r));
  }

  const Registry& registry_;
  const Plan& plan_;
  Store& store_;
  const LabOptions& options_;
  WorkPool pool_;
  std::map<std::pair<std::string, int>, std::unique_ptr<Lesson>> lessons_;
  std::vector<Task> tasks_;
  std::vector<Meter> meters_;
  std::atomic<int> livesDone_{0};
  std::mutex mutex_;  // guards store_ and result_ while the pool runs
  LabResult result_;
};

}  // namespace

Result<LabResult> runPlan(const Registry& registry, const Plan& plan, Store& store, const LabOptions& options) {
  return Laboratory(registry, plan, store, options).run();
}

}  // namespace surefoot
