// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Session that begins lives anew: from files, with what was learned before, or in another environment.
#include <chrono>
#include <new>

#include "core/experiment/experiment.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"
#include "core/saved/resample.h"
#include "ui/session/session.h"

namespace surefoot {

namespace {

/// So long the window may stand still for a table, so that those of usual size are there at once.
constexpr std::chrono::milliseconds kPatience(100);

/// A journal longer than this is left to `surefoot replay`: about ten seconds.
constexpr std::int64_t kMostReplayed = 10'000'000;  // [steps]

/// The bytes of a file that holds the life.
std::string bytesOf(const Life& life, const Configuration& began, const Configuration& now, SavedAs what) {
  switch (what) {
    case SavedAs::Session:
      return checkpointOf(life, began, false).write();
    case SavedAs::QFunction:
      return qFileOf(life, now).write();
    case SavedAs::Journal:
      break;
  }
  return journalOf(began, summarise(life, 0, 0.0));
}

}  // namespace

namespace {

/// Writes a life; what it learned may need more memory than there is.
Status write(const Life& life, const Configuration& began, const Configuration& now, SavedAs what,
             const std::string& path) {
  if (life.changesLeftOut() && what == SavedAs::Journal)
    return Error{"More was changed than a journal holds; save the session instead."};
  if (life.diverged() && what != SavedAs::Journal)
    return Error{"The action values diverged; there is nothing worth keeping."};
  try {
    return writeWhole("file", path, bytesOf(life, began, now, what));
  } catch (const std::bad_alloc&) {
    return Error{path + ": there is not enough memory to write it; nothing is lost."};
  }
}

}  // namespace

// Written on the learner's thread, between two steps: the life stands still meanwhile.
void Session::save(SavedAs what, const std::string& path, Then then) {
  learner_->send(Visit{[this, what, path, then = std::move(then), began = began_, now = configuration_,
                        of = lifeSent_](const Life& life) {
    const Status status = write(life, began, now, what, path);
    QMetaObject::invokeMethod(
        this,
        [this, then, status, of, written = LifeProgress{life.log().totals().episodes, life.steps()}] {
          written_.reset();
          if (of == lifeSent_) written_ = written;
          then(status);
        },
        Qt::QueuedConnection);
  }});
}

void Session::saveKept(const KeptLife& kept, const std::string& path, Then then) {
  learner_->send(Visit{[this, path, then = std::move(then), aside = kept.aside, began = kept.began,
                        now = kept.configuration](const Life&) {
    const Status status = aside && aside->life ? write(*aside->life, began, now, SavedAs::Session, path)
                                               : Status(Error{"The life is not kept any more."});
    QMetaObject::invokeMethod(
        this, [then, status] { then(status); }, Qt::QueuedConnection);
  }});
}

void Session::open(const std::string& path, const Then& then) {
  const auto head = readHead(path, 1);
  if (!head) return then(head.error());
  static_cast<void>(whenMade(
      *head == "{" ? makeOfJournal(path) : makeOfFile(path),
      [this](Beginning made) { return beginWithLife(std::move(made)); }, then));
}

Session::Make Session::makeOfFile(const std::string& path) const {
  return [this, path, now = configuration_](const std::atomic<bool>&) -> Result<Beginning> {
    try {
      auto file = readQFile(path);
      if (!file) return file.error();
      if ((*file)->about.value("kind", "") == "checkpoint") {
        auto resumed = resume(registry_, *file, {}, Versions::Any);
        if (!resumed) return resumed.error();
        resumed->life->keepInputs();
        const Life& life = *resumed->life;
        const bool named = path.ends_with(".surefoot");  // another name may be another program's
        LifeFile from{named ? QString::fromStdString(path) : QString(), {life.log().totals().episodes, life.steps()}};
        const Status same = checkLivesVersion(**file);
        return Beginning{std::move(resumed->configuration), std::move(resumed->life), std::move(from),
                         same ? "" : same.error().message + " It goes on with those of this one."};
      }
      auto learned = configurationOf(registry_, **file);
      if (!learned) return learned.error();
      learned->seed = now.seed;
      learned->minutes = now.minutes;
      learned->episodes = now.episodes;
      beginWith(*learned, std::move(*file));
      auto life = makeLifeOf(*learned);
      if (!life) return life.error();
      return Beginning{std::move(*learned), std::move(*life)};
    } catch (const std::bad_alloc&) {
      return Error{path + ": there is not enough memory for what it holds."};
    }
  };
}

Session::Make Session::makeOf(Configuration configuration) const {
  return [this, configuration = std::move(configuration)](const std::atomic<bool>&) -> Result<Beginning> {
    auto life = makeLifeOf(configuration);
    if (!life) return life.error();
    return Beginning{configuration, std::move(*life)};
  };
}

Status Session::whenMade(Make make, Adopt adopt, const Then& then) {
  struct Work {
    Result<Beginning> made = Error{"cancelled"};
    bool returned = false;
    Status status = Done{};
  };
  const auto work = std::make_shared<Work>();
  const auto finish = [this, work, adopt = std::move(adopt), then] {
    work->status = work->made ? adopt(std::move(*work->made)) : Status(work->made.error());
    if (then) return then(work->status);
    if (work->returned && !work->status) Q_EMIT refused(QString::fromStdString(work->status.error().message));
  };
  background_.start(
      [work, make = std::move(make)](const std::atomic<bool>& interrupted) { work->made = make(interrupted); },
      [this, work, finish] { work->made ? finishOrAsk(finish) : finish(); }, kPatience);
  work->returned = true;
  return work->status;
}

void Session::finishOrAsk(std::function<void()> finish) {
  const bool keeps = canKeep();
  const auto least = learned() && keeps ? withoutRoom(bytesOfLife(), 1) : nullptr;
  const auto end = [this, keeps, finish = std::move(finish)] {
    keepsBefore_ = keeps || canKeep();  // what was found out before does not change between question and answer
    finish();
  };
  if (askBeforeEnding_ && ((unsaved() && !keeps) || (least && least->unsaved())))
    askBeforeEnding_(least, end);
  else
    end();
}

Status Session::beginAgain(Configuration configuration) {
  return whenMade(makeOf(std::move(configuration)), [this](Beginning made) -> Status {
    auto before = putAsideIfLearned();
    if (before) lineage_ = ++lineages_;
    began_ = configuration_ = std::move(made.configuration);
    adopt(std::move(made.life), before);
    Q_EMIT configurationChanged();
    keepForUndo(std::move(before));
    return Done{};
  });
}

Session::Make Session::makeOfJournal(const std::string& path) const {
  return [this, path](const std::atomic<bool>& interrupted) -> Result<Beginning> {
    const auto text = readText(path);
    if (!text) return text.error();
    auto journal = parseJournal(registry_, *text, path);
    if (!journal) return journal.error();
    if (journal->steps > kMostReplayed)
      return Error{path + ": the life in it is too long to be lived again while one waits; `surefoot replay` does it."};
    auto made = makeOf(std::move(journal->configuration))(interrupted);
    if (!made) return made;
    Life& life = *made->life;
    while (life.steps() < journal->steps && !life.finished() && !interrupted) life.step();
    made->file = LifeFile{{}, {life.log().totals().episodes, life.steps()}};  // the journal is as good as a copy
    return made;
  };
}

Status Session::begin(Configuration configuration) {
  return whenMade(makeOf(std::move(configuration)), [this](Beginning made) { return beginWithLife(std::move(made)); });
}

Status Session::beginWithLife(Beginning made) {
  auto before = putAsideIfLearned();
  lineage_ = ++lineages_;
  began_ = std::move(made.configuration);
  configuration_ = began_;
  configuration_.commands.clear();
  configuration_.parameters = made.life->parameters();
  configuration_.names.policy = made.life->policyName();
  base_ = baseOf(configuration_.names);
  if (!before && unsavedBefore().empty()) forgetChanges();
  adopt(std::move(made.life), before);
  if (made.file) setFile(std::move(*made.file));
  Q_EMIT parametersReplaced();
  Q_EMIT configurationChanged();
  keepForUndo(std::move(before));
  if (!made.remark.empty()) Q_EMIT remarked(QString::fromStdString(made.remark));
  return Done{};
}

Status Session::beginEnvironment(const std::string& name) {
  Names names;
  names.environment = name;
  names.policy = configuration_.names.policy;
  const auto entry = findEntry(registry_.environments, "environment", name);
  if (!entry) return entry.error();
  auto configuration = configure(registry_, names, {});
  if (!configuration) return configuration.error();
  configuration->seed = configuration_.seed;
  return begin(std::move(*configuration));
}

Status Session::setSeed(std::uint64_t seed) {
  Configuration changed = configuration_;
  changed.seed = seed;
  return begin(std::move(changed));
}

namespace {

/// What carrying a function over needs, and gives.
struct CarriedOver {
  std::shared_ptr<const ActionValueFunction> from;
  Configuration to;
  Result<TensorFile> file = Error{"cancelled"};
};

Result<TensorFile> fitted(const Registry& registry, const CarriedOver& work, const std::atomic<bool>& interrupted) {
  const auto environment = makeEnvironment(registry, work.to);
  if (!environment) return environment.error();
  const Task& task = (*environment)->task();
  const auto entry = findEntry(registry.agents, "agent", work.to.names.agent);
  if (!entry) return entry.error();
  try {
    auto agent = (*entry)->make({task, work.to.names.features, work.to.parameters, 0});
    if (!agent) return agent.error();
    resample(*work.from, **agent, task, &interrupted);
    return qFileOf(**agent, task, work.to, Json{{"carried_over", true}});
  } catch (const std::bad_alloc&) {
    return Error{"There is not enough memory for this; take fewer tiles or tilings."};
  }
}

}  // namespace

void Session::carryOver(const std::string& key, double value, Then then) {
  auto work = std::make_shared<CarriedOver>();
  work->to = configuration_;
  if (const Status s = work->to.parameters.set(key, value); !s) return then(s);
  const auto end = [this, work, then] {
    if (!work->file) return then(work->file.error());
    beginWith(work->to, std::make_shared<const TensorFile>(std::move(*work->file)));
    then(begin(std::move(work->to)));
  };
  const auto fit = [this, work, end] {
    background_.start([work, &registry = registry_](
                          const std::atomic<bool>& interrupted) { work->file = fitted(registry, *work, interrupted); },
                      end);
  };
  learner_->send(Visit{[this, work, fit](const Life& life) {  // a copy of what is learned up to now
    work->from = life.agent().values().clone();
    QMetaObject::invokeMethod(this, fit, Qt::QueuedConnection);
  }});
}

}  // namespace surefoot
