// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/autosave.h"

#include <QCoreApplication>
#include <QDir>

#include "ui/session.h"

namespace surefoot {

namespace {
const QString kPrefix = QStringLiteral("autosave-");
const QString kEnding = QStringLiteral(".surefoot");

const QString kLock = QStringLiteral(".lock");

/// A number of a process may be in use again, by anyone; a lock knows better.
bool isRunning(const QString& file) {
  QLockFile lock(file + kLock);
  lock.setStaleLockTime(0);
  return !lock.tryLock();
}

/// The files of processes that are gone, the newest first.
QStringList orphans(const QString& folder) {
  QStringList list;
  for (const QString& file : QDir(folder).entryList({kPrefix + '*' + kEnding}, QDir::Files, QDir::Time))
    if (const QString path = QDir(folder).filePath(file); !isRunning(path)) list << path;
  return list;
}
}  // namespace

Autosave::Autosave(Session& session, QString folder, QObject* parent)
    : QObject(parent),
      session_(session),
      folder_(std::move(folder)) {
  QDir().mkpath(folder_);
  lock_ = std::make_unique<QLockFile>(path() + kLock);
  lock_->setStaleLockTime(0);
  lock_->tryLock();
  connect(&timer_, &QTimer::timeout, this, &Autosave::tick);
  setMinutes(1);
  timer_.start();
}

void Autosave::tick() {
  constexpr std::size_t kEach = 32u << 20;  // [bytes] that may be written a tick
  const auto* values = session_.values() ? session_.values()->values.get() : nullptr;
  const std::size_t rest = values ? values->bytes() / kEach : 0;
  if (static_cast<std::size_t>(waited_++) < rest) return;
  waited_ = 0;
  save();
}

QString Autosave::path() const {
  return QDir(folder_).filePath(kPrefix + QString::number(QCoreApplication::applicationPid()) + kEnding);
}

QString Autosave::leftBehind() const {
  const QStringList list = orphans(folder_);
  return list.isEmpty() ? QString() : list.front();
}

void Autosave::forget(const QString& file) {
  QFile::remove(file);
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
    if (s && !replaces.isEmpty() && replaces != path()) QFile::remove(replaces);
    if (s && replaces == takenOver_) takenOver_.clear();
    if (then) then();
    if (again_ && !leaving_) {
      again_ = false;
      saved_ = -1;
      save();
    }
  };
  session_.save(SavedAs::Session, path().toStdString(), written);
}

void Autosave::leave(std::function<void()> then) {
  timer_.stop();
  leaving_ = true;
  save(std::move(then));
}

void Autosave::finish() {
  timer_.stop();
  if (!leaving_) QFile::remove(path());
  lock_->unlock();
}

}  // namespace surefoot
