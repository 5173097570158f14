// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/autosave.h"

#include <signal.h>

#include <QCoreApplication>
#include <QDir>

#include "ui/session.h"

namespace surefoot {

namespace {
const QString kPrefix = QStringLiteral("autosave-");
const QString kEnding = QStringLiteral(".surefoot");

bool isRunning(const QString& file) {
  const qint64 process = file.mid(kPrefix.size(), file.size() - kPrefix.size() - kEnding.size()).toLongLong();
  return process > 0 && ::kill(static_cast<pid_t>(process), 0) == 0;
}

/// The files of processes that are gone, the newest first.
QStringList orphans(const QString& folder) {
  QStringList list;
  for (const QString& file : QDir(folder).entryList({kPrefix + '*' + kEnding}, QDir::Files, QDir::Time))
    if (!isRunning(file)) list << QDir(folder).filePath(file);
  return list;
}
}  // namespace

Autosave::Autosave(Session& session, QString folder, QObject* parent)
    : QObject(parent),
      session_(session),
      folder_(std::move(folder)) {
  connect(&timer_, &QTimer::timeout, this, &Autosave::save);
  setMinutes(1);
  timer_.start();
}

QString Autosave::path() const {
  return QDir(folder_).filePath(kPrefix + QString::number(QCoreApplication::applicationPid()) + kEnding);
}

QString Autosave::leftBehind() const {
  const QStringList list = orphans(folder_);
  return list.isEmpty() ? QString() : list.front();
}

void Autosave::forget() {
  for (const QString& file : orphans(folder_)) QFile::remove(file);
}

void Autosave::save() {
  if (writing_ || session_.snapshot().steps == saved_ || !QDir().mkpath(folder_)) return;
  saved_ = session_.snapshot().steps;
  writing_ = true;
  // A full disk is no reason to disturb; the next try may work.
  session_.save(SavedAs::Session, path().toStdString(), [this](const Status&) { writing_ = false; });
}

void Autosave::finish() {
  timer_.stop();
  QFile::remove(path());
}

}  // namespace surefoot
