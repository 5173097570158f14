// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/crash/crash_reports.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <cstdio>

namespace surefoot {

namespace {
const QString kPrefix = QStringLiteral("crash-"), kEnding = QStringLiteral(".txt");
const QString kLast = QStringLiteral("last-crash.txt");
}  // namespace

QString crashFile(const QString& folder) {
  return QDir(folder).filePath(kPrefix + QString::number(QCoreApplication::applicationPid()) + '-' +
                               QString::number(QDateTime::currentMSecsSinceEpoch(), 36) + kEnding);
}

bool takeNewCrash(const QString& folder) {
  const QDir data(folder);
  const QStringList reports = data.entryList({kPrefix + '*' + kEnding}, QDir::Files, QDir::Time);
  bool taken = false;
  for (const QString& report : reports) {  // the newest first
    const QByteArray path = QFile::encodeName(data.filePath(report));
    if (taken)
      QFile::remove(data.filePath(report));
    else
      taken = std::rename(path.constData(), QFile::encodeName(data.filePath(kLast)).constData()) == 0;
  }
  return taken;
}

QString lastCrash(const QString& folder) {
  const QString path = QDir(folder).filePath(kLast);
  return QFile::exists(path) ? path : QString();
}

}  // namespace surefoot
