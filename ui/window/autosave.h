// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the session on the disk while the window is open, so that a crash loses little, and the last one when it is
// closed, so that it can go on at the next start. Each process has a file of its own and holds a lock beside it. If
// nobody holds the lock, the file was left by a process that is gone.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "core/basics/result.h"
#include "ui/support/file_lock.h"

namespace surefoot {

struct KeptLife;
class History;
class LifeFiles;
class RunningLife;

class Autosave final : public QObject {
  Q_OBJECT

 public:
  /// Once a minute, until it is told otherwise; tables of many megabytes less often, because the learner stands still
  /// while they are written. Locks that nobody holds any more are removed.
  Autosave(RunningLife& life, History& history, LifeFiles& files, QString folder, QObject* parent = nullptr);
  void setMinutes(int minutes) { timer_.setInterval(minutes * 60'000); }
  /// The newest file that was left by a crash or an end from outside, else by the last window that was closed. Empty:
  /// none. While it is offered here, other windows do not offer it.
  QString leftBehind() const;
  /// Whether a file was left when its window was closed.
  static bool isOfLastSession(const QString& file);
  /// Holds the file's lock while the file is offered here; false: another window was faster.
  bool claim(const QString& file);
  /// Removes a file that was left.
  void forget(const QString& file);
  /// The claimed file stays for the next start.
  void leaveThere() { claimed_.release(); }
  /// The session goes on from a file that was left: that file is removed when this process has written its own.
  void takeOver(const QString& file);
  /// Writes now, if the life has gone on since the last time, and calls `then` with the result.
  void save(std::function<void(const Status&)> then = {});
  /// Renames a file that cannot be read, so that it is not offered again; empty: it could not be renamed.
  QString setAside(const QString& file);
  /// The window is closed: writes what was learned, the lives before that were not saved, too, to be offered at the
  /// next start, then calls `then` with the first that could not be written.
  void keepLast(std::function<void(const Status&)> then);
  /// The window was closed; its autosaves go, unless keepLast() failed.
  void finish();
  /// The program is ended from outside: writes once more, leaves the file, then calls `then`.
  void leave(std::function<void(const Status&)> then);

 private:
  /// A life that was written and then replaced; the next life must not be written over its file.
  struct Before {
    QString path;
    FileLock lock;
    std::weak_ptr<KeptLife> life;
  };

  void tick();
  void beginAnotherFile();
  void forgetBefore();
  void removeOldSessions(const QStringList& but) const;

  RunningLife& life_;
  History& history_;
  LifeFiles& files_;
  int waited_ = 0;  // ticks since the last writing
  QString folder_, path_;
  QTimer timer_;
  std::int64_t saved_ = -1;  // steps of the life when it was last written
  bool writing_ = false, leaving_ = false, again_ = false, unwritten_ = false;
  QString takenOver_;
  FileLock lock_, claimed_;
  std::vector<Before> before_;
};

}  // namespace surefoot
