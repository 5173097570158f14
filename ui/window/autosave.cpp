// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <algorithm>

#include "ui/running/running_life.h"
#include "ui/session/history.h"
#include "ui/session/life_files.h"

namespace surefoot {

namespace {
const QString kPrefix = QStringLiteral("autosave-");
const QString kLast = QStringLiteral("last-session-");
const QString kEnding = QStringLiteral(".surefoot");
const QString kLock = QStringLiteral(".lock");
constexpr std::size_t kMostBefore = 3;  // files of earlier lives that are kept
constexpr int kMostLast = 3;            // closed sessions that are kept,
constexpr qint64 kLarge = 64ll << 20;   // and only one of those larger than this [bytes]

/// Removes the lock files of processes that are gone.
void removeStaleLocks(const QString& folder) {
  for (const QString& file : QDir(folder).entryList({kPrefix + '*' + kLock, kLast + '*' + kLock}, QDir::Files))
    FileLock::take(QDir(folder).filePath(file)).release();
}

/// The files of processes that are gone, the newest first.
QStringList orphans(const QString& folder, const QString& prefix) {
  QStringList list;
  for (const QString& file : QDir(folder).entryList({prefix + '*' + kEnding}, QDir::Files, QDir::Time))
    if (const QString path = QDir(folder).filePath(file); FileLock::take(path + kLock).held()) list << path;
  return list;
}

/// A name that no other process has had: process numbers are used again, so the time is in it as well.
QString newPath(const QString& folder, const QString& prefix) {
  static qint64 last = 0;  // the last number given out; its file may not exist yet
  for (qint64 i = std::max(QDateTime::currentMSecsSinceEpoch(), last + 1);; ++i) {
    const QString name = QStringLiteral("%1%2-%3").arg(prefix).arg(QCoreApplication::applicationPid()).arg(i, 0, 36);
    const QString path = QDir(folder).filePath(name + kEnding);
    if (!QFile::exists(path) && !QFile::exists(path + kLock)) return last = i, path;
  }
}
}  // namespace

Autosave::Autosave(RunningLife& life, History& history, LifeFiles& files, QString folder, QObject* parent)
    : QObject(parent),
      life_(life),
      history_(history),
      files_(files),
      folder_(std::move(folder)),
      path_(newPath(folder_, kPrefix)) {
  QDir().mkpath(folder_);
  removeStaleLocks(folder_);
  lock_ = FileLock::take(path_ + kLock);
  connect(&timer_, &QTimer::timeout, this, &Autosave::tick);
  connect(&history_, &History::lifeKept, this, &Autosave::beginAnotherFile);
  connect(&history_, &History::lifeBroughtBack, this, &Autosave::beginAnotherFile);
  setMinutes(1);
  timer_.start();
}

void Autosave::tick() {
  constexpr std::size_t kEach = 32u << 20;  // [bytes] that may be written per tick
  if (!life_.learned()) return;             // an earlier file of a life that learned something is worth more
  const auto* values = life_.values() ? life_.values()->values.get() : nullptr;
  const std::size_t rest = values ? values->bytes() / kEach : 0;
  if (static_cast<std::size_t>(waited_++) < rest) return;
  waited_ = 0;
  save();
}

/// The file of the life before is not overwritten until that life is saved, brought back or dropped.
void Autosave::beginAnotherFile() {
  const auto kept = history_.lastKept();
  if (saved_ < 0 || !kept || kept->known.progress.steps < saved_) return;
  before_.push_back({path_, std::move(lock_), kept});
  if (before_.size() > kMostBefore) {
    const auto least = std::min_element(before_.begin(), before_.end(), [](const Before& a, const Before& b) {
      const auto one = a.life.lock(), other = b.life.lock();
      return (one ? one->known.progress.steps : 0) < (other ? other->known.progress.steps : 0);
    });
    QFile::remove(least->path);
    before_.erase(least);
  }
  path_ = newPath(folder_, kPrefix);
  lock_ = FileLock::take(path_ + kLock);
  saved_ = -1;
  again_ = writing_;  // a file in writing still holds the life before
}

/// The present life is on the disk. The file of an earlier life stays only while undo keeps that life unsaved.
void Autosave::forgetBefore() {
  std::erase_if(before_, [](const Before& b) {
    const auto life = b.life.lock();
    const bool needed = life && life->unsaved();
    if (!needed) QFile::remove(b.path);
    return !needed;
  });
}

QString Autosave::leftBehind() const {
  for (const QString& prefix : {kPrefix, kLast})
    if (const QStringList list = orphans(folder_, prefix); !list.isEmpty()) return list.front();
  return {};
}

bool Autosave::isOfLastSession(const QString& file) {
  return QFileInfo(file).fileName().startsWith(kLast);
}

bool Autosave::claim(const QString& file) {
  claimed_ = FileLock::take(file + kLock);
  return claimed_.held();
}

void Autosave::forget(const QString& file) {
  QFile::remove(file);
  claimed_.release();
}

void Autosave::takeOver(const QString& file) {
  takenOver_ = file;
  saved_ = -1;
  again_ = writing_;  // a file in writing still holds the session before
  save();
}

void Autosave::save(std::function<void(const Status&)> then) {
  const auto tell = [then](const Status& s) {
    if (then) then(s);
  };
  if (writing_ || life_.snapshot().steps == saved_) return tell(Done{});
  if (!QDir().mkpath(folder_)) return tell(Error{tr("%1 cannot be made.").arg(folder_).toStdString()});
  saved_ = life_.snapshot().steps;
  writing_ = true;
  // A full disk is no reason to disturb; the next try may work.
  const auto written = [this, replaces = takenOver_, tell](const Status& s) {
    writing_ = false;
    if (!s) saved_ = -1;
    if (s && !replaces.isEmpty() && replaces != path_) forget(replaces);
    if (s && replaces == takenOver_) takenOver_.clear();
    if (s && !again_) forgetBefore();
    tell(s);
    if (again_ && !leaving_) {
      again_ = false;
      saved_ = -1;
      save();
    }
  };
  files_.save(SavedAs::Session, path_.toStdString(), written);
}

void Autosave::leave(std::function<void(const Status&)> then) {
  timer_.stop();
  leaving_ = true;
  const auto before = history_.unsavedBefore();
  if (before.empty() && life_.file().followed) return then(Done{});
  if (life_.learned() || before.empty()) return save(std::move(then));
  files_.saveKept(*before.back(), path_.toStdString(), std::move(then));
}

QString Autosave::setAside(const QString& file) {
  for (int i = 1; i < 100; ++i) {
    const QString aside = file + (i == 1 ? QStringLiteral(".damaged") : QStringLiteral(".damaged-%1").arg(i));
    if (QFile::exists(aside)) continue;
    return QFile::rename(file, aside) ? aside : QString();
  }
  return {};
}

// The life that runs is written last, so that it is offered first.
void Autosave::keepLast(std::function<void(const Status&)> then) {
  timer_.stop();
  const auto before = history_.unsavedBefore();
  if (!life_.learned() && before.empty()) return then(Done{});
  if (!QDir().mkpath(folder_)) return then(Error{tr("%1 cannot be made.").arg(folder_).toStdString()});
  unwritten_ = true;
  struct Work {
    std::size_t left = 0;
    Status status = Done{};
    QStringList written;
  };
  const auto work = std::make_shared<Work>();
  work->left = before.size() + (life_.learned() ? 1 : 0);
  const auto one = [this, work, then = std::move(then)](const QString& path) {
    return [this, work, then, path](const Status& s) {
      if (s) work->written << path;
      if (!s && work->status) work->status = s;
      if (--work->left > 0) return;
      unwritten_ = !work->status;
      removeOldSessions(work->written);
      if (work->status && !takenOver_.isEmpty()) forget(takenOver_);
      then(work->status);
    };
  };
  for (const auto& kept : before) {
    const QString path = newPath(folder_, kLast);
    files_.saveKept(*kept, path.toStdString(), one(path));
  }
  if (!life_.learned()) return;
  const QString path = newPath(folder_, kLast);
  files_.save(SavedAs::Session, path.toStdString(), one(path));
}

void Autosave::removeOldSessions(const QStringList& but) const {
  int place = 0;
  for (const QString& file : orphans(folder_, kLast))
    if (!but.contains(file) && (++place >= kMostLast || QFileInfo(file).size() > kLarge)) QFile::remove(file);
}

void Autosave::finish() {
  timer_.stop();
  if (!leaving_ && !unwritten_) {
    QFile::remove(path_);
    // A file in writing appears after this: what the learner's thread writes it removes again.
    if (writing_) life_.visit([path = path_](const Life&) { QFile::remove(path); });
    for (const Before& b : before_) QFile::remove(b.path);
  }
  lock_.release();
  claimed_.release();
  before_.clear();
}

}  // namespace surefoot

#include "moc_autosave.cpp"
