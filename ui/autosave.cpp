// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include "ui/session.h"

namespace surefoot {

namespace {
const QString kPrefix = QStringLiteral("autosave-");
const QString kLast = QStringLiteral("last-session-");
const QString kEnding = QStringLiteral(".surefoot");
const QString kLock = QStringLiteral(".lock");
constexpr int kMostLast = 3;           // sessions that were closed and not asked for since,
constexpr qint64 kLarge = 64ll << 20;  // and of those that are larger [bytes] one

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

/// A name that no other process has had: a number of a process is used again.
QString newPath(const QString& folder, const QString& prefix) {
  for (qint64 i = QDateTime::currentMSecsSinceEpoch();; ++i) {
    const QString name = QStringLiteral("%1%2-%3").arg(prefix).arg(QCoreApplication::applicationPid()).arg(i, 0, 36);
    const QString path = QDir(folder).filePath(name + kEnding);
    if (!QFile::exists(path) && !QFile::exists(path + kLock)) return path;
  }
}
}  // namespace

Autosave::Autosave(Session& session, QString folder, QObject* parent)
    : QObject(parent),
      session_(session),
      folder_(std::move(folder)),
      path_(newPath(folder_, kPrefix)) {
  QDir().mkpath(folder_);
  removeStaleLocks(folder_);
  lock_ = FileLock::take(path_ + kLock);
  connect(&timer_, &QTimer::timeout, this, &Autosave::tick);
  setMinutes(1);
  timer_.start();
}

void Autosave::tick() {
  constexpr std::size_t kEach = 32u << 20;  // [bytes] that may be written a tick
  if (!session_.learned()) return;          // one that learned something, written before, is worth more
  const auto* values = session_.values() ? session_.values()->values.get() : nullptr;
  const std::size_t rest = values ? values->bytes() / kEach : 0;
  if (static_cast<std::size_t>(waited_++) < rest) return;
  waited_ = 0;
  save();
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
  again_ = writing_;  // what is being written is still the session before
  save();
}

void Autosave::save(std::function<void()> then) {
  if (writing_ || session_.snapshot().steps == saved_ || !QDir().mkpath(folder_)) {
    if (then) then();
    return;
  }
  saved_ = session_.snapshot().steps;
  writing_ = true;
  // A full disk is no reason to disturb; the next try may work.
  const auto written = [this, replaces = takenOver_, then = std::move(then)](const Status& s) {
    writing_ = false;
    if (s && !replaces.isEmpty() && replaces != path_) forget(replaces);
    if (s && replaces == takenOver_) takenOver_.clear();
    if (then) then();
    if (again_ && !leaving_) {
      again_ = false;
      saved_ = -1;
      save();
    }
  };
  session_.save(SavedAs::Session, path_.toStdString(), written);
}

void Autosave::leave(std::function<void()> then) {
  timer_.stop();
  leaving_ = true;
  const auto before = session_.unsavedBefore();
  if (session_.learned() || before.empty()) return save(std::move(then));
  session_.saveKept(*before.back(), path_.toStdString(), [then = std::move(then)](const Status&) { then(); });
}

void Autosave::keepLast(std::function<void()> then) {
  timer_.stop();
  const auto before = session_.unsavedBefore();
  if ((!session_.learned() && before.empty()) || !QDir().mkpath(folder_)) return then();
  const QString path = newPath(folder_, kLast);
  const auto written = [this, path, then = std::move(then)](const Status& s) {
    QStringList old = orphans(folder_, kLast);
    old.removeAll(path);
    for (int i = 0; i < old.size(); ++i)
      if (i >= kMostLast - 1 || QFileInfo(old[i]).size() > kLarge) QFile::remove(old[i]);
    if (s && !takenOver_.isEmpty()) forget(takenOver_);
    then();
  };
  if (session_.learned())
    session_.save(SavedAs::Session, path.toStdString(), written);
  else
    session_.saveKept(*before.back(), path.toStdString(), written);
}

void Autosave::finish() {
  timer_.stop();
  if (!leaving_) QFile::remove(path_);
  lock_.release();
  claimed_.release();
}

}  // namespace surefoot
