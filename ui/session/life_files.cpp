// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/life_files.h"

#include <new>

#include "core/c_policy/known_actions.h"
#include "core/experiment/experiment.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/journal.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

/// A journal longer than this is left to `surefoot replay`: about ten seconds.
constexpr std::int64_t kMostReplayed = 10'000'000;  // [steps]

/// The greedy policy as C, with a check of a thousand states.
Result<std::string> policyOf(const Life& life, const Configuration& now, const std::string& path) {
  const TensorFile file = qFileOf(life, now);
  const Task& task = life.environment().task();
  const bool floats = tableBytesOf(file, false) > kMostCTables;  // in single precision where there is no other way
  return policyAsC(
      file, task,
      {.floats = floats, .known = knownActions(life.agent().values(), task), .origin = originOf(file, path)});
}

/// The bytes of a file that holds the life.
std::string bytesOf(const Life& life, const Configuration& began, const Configuration& now, SavedAs what) {
  switch (what) {
    case SavedAs::Session:
      return checkpointOf(life, began, false).write();
    case SavedAs::QFunction:
      return qFileOf(life, now).write();
    case SavedAs::Journal:
    case SavedAs::PolicyInC:
      break;
  }
  return journalOf(began, summarise(life, 0, 0.0));
}

/// Writes a life; an error if memory is too small for its values.
Status write(const Life& life, const Configuration& began, const Configuration& now, SavedAs what,
             const std::string& path) {
  if (life.changesLeftOut() && what == SavedAs::Journal)
    return Error{QObject::tr("More was changed than a journal holds; save the session instead.").toStdString()};
  if (life.diverged() && what != SavedAs::Journal)
    return Error{QObject::tr("The action values diverged; there is nothing worth keeping.").toStdString()};
  try {
    if (what == SavedAs::PolicyInC) {
      const auto text = policyOf(life, now, path);
      return text ? writeWhole("file", path, *text) : Status(Error{path + text.error().message});
    }
    return writeWhole("file", path, bytesOf(life, began, now, what));
  } catch (const std::bad_alloc&) {
    return Error{path + ": there is not enough memory to write it; nothing is lost."};
  }
}

}  // namespace

// Written on the learner's thread, between two steps: the life stands still meanwhile.
void LifeFiles::save(SavedAs what, const std::string& path, Then then) {
  life_.visit([this, what, path, then = std::move(then), began = life_.began(), now = life_.configuration(),
               of = life_.number()](const Life& life) {
    const Status status = write(life, began, now, what, path);
    calls_.post([this, then, status, of, written = LifeProgress{life.log().totals().episodes, life.steps()}] {
      lastWritten_ = written;
      written_.reset();
      if (of == life_.number()) written_ = written;
      then(status);
    });
  });
}

void LifeFiles::copyFunction(std::function<void(const Function&)> then) {
  life_.visit([this, then = std::move(then), now = life_.configuration()](const Life& life) {
    Function function = Error{QObject::tr("The action values diverged; there is nothing to try.").toStdString()};
    try {
      if (!life.diverged()) function = std::make_shared<const TensorFile>(qFileOf(life, now));
    } catch (const std::bad_alloc&) {
      function = Error{
          QObject::tr("There is not enough memory for a copy of the action values; nothing is lost.").toStdString()};
    }
    calls_.post([then, function] { then(function); });
  });
}

void LifeFiles::saveKept(const KeptLife& kept, const std::string& path, Then then) {
  life_.visit([this, path, then = std::move(then), aside = kept.aside, began = kept.known.began,
               now = kept.known.configuration](const Life&) {
    const Status status = aside && aside->life
                              ? write(*aside->life, began, now, SavedAs::Session, path)
                              : Status(Error{QObject::tr("The life is not kept any more.").toStdString()});
    calls_.post([then, status] { then(status); });
  });
}

void LifeFiles::open(const std::string& path, const Then& then) {
  const auto head = readHead(path, 1);
  if (!head) return then(head.error());
  static_cast<void>(newLives_.beginWhenMade(*head == "{" ? makeOfJournal(path) : makeOfFile(path), then));
}

Result<NewLives::Made> lifeOf(const Registry& registry, const std::shared_ptr<const TensorFile>& checkpoint) {
  auto resumed = resume(registry, checkpoint, {}, Versions::Any);
  if (!resumed) return resumed.error();
  resumed->life->keepInputs();
  const Life& life = *resumed->life;
  const Status same = checkLivesVersion(*checkpoint);
  LifeFile from{{}, {life.log().totals().episodes, life.steps()}};
  return NewLives::Made{std::move(resumed->configuration), std::move(resumed->life), std::move(from),
                        same ? "" : same.error().message + " It goes on with those of this one."};
}

NewLives::Make LifeFiles::makeOfFile(const std::string& path) const {
  return [&registry = life_.registry(), keepRows = life_.keepsRows(), path,
          now = life_.configuration()](const std::atomic<bool>&) -> Result<NewLives::Made> {
    try {
      auto file = readQFile(path);
      if (!file) return file.error();
      if ((*file)->about.value("kind", "") == "checkpoint") {
        auto made = lifeOf(registry, *file);
        if (made && path.ends_with(".surefoot"))  // a file with another ending may belong to another program
          made->file->path = QString::fromStdString(path);
        return made;
      }
      auto learned = configurationOf(registry, **file);
      if (!learned) return learned.error();
      learned->seed = now.seed;
      learned->minutes = now.minutes;
      learned->episodes = now.episodes;
      beginWith(*learned, std::move(*file));
      auto life = makeLifeToRun(registry, *learned, keepRows);
      if (!life) return life.error();
      return NewLives::Made{std::move(*learned), std::move(*life)};
    } catch (const std::bad_alloc&) {
      return Error{path + ": there is not enough memory for what it holds."};
    }
  };
}

NewLives::Make LifeFiles::makeOfJournal(const std::string& path) const {
  return [&newLives = newLives_, &registry = life_.registry(),
          path](const std::atomic<bool>& interrupted) -> Result<NewLives::Made> {
    const auto text = readText(path);
    if (!text) return text.error();
    auto journal = parseJournal(registry, *text, path);
    if (!journal) return journal.error();
    if (journal->steps > kMostReplayed)
      return Error{path + ": the life in it is too long to be lived again while one waits; `surefoot replay` does it."};
    auto made = newLives.makeOf(std::move(journal->configuration))(interrupted);
    if (!made) return made;
    Life& life = *made->life;
    while (life.steps() < journal->steps && !life.finished() && !interrupted) life.step();
    if (!life.unanswered().empty()) return Error{life.unanswered()};
    made->file = LifeFile{{}, {life.log().totals().episodes, life.steps()}};  // the journal is as good as a copy
    return made;
  };
}

}  // namespace surefoot

#include "moc_life_files.cpp"
