// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the session on the disk while the window is open, so that a crash loses little. The file is named
// after the process, which holds a lock beside it; one without was left by a crash.
#pragma once

#include <QLockFile>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

namespace surefoot {

class Session;

class Autosave final : public QObject {
  Q_OBJECT

 public:
  /// Once a minute, until it is told otherwise; tables of many megabytes less often, because the learner stands still
  /// while they are written.
  Autosave(Session& session, QString folder, QObject* parent = nullptr);
  void setMinutes(int minutes) { timer_.setInterval(minutes * 60'000); }
  /// What a crash left, the newest; empty: nothing.
  QString leftBehind() const;
  /// Removes one that a crash left.
  static void forget(const QString& file);
  /// The session goes on from one that a crash left: it is removed when this process has written one of its own.
  void takeOver(const QString& file);
  /// Writes now, if the life has moved since.
  void save(std::function<void()> then = {});
  /// The window was closed properly: nothing needs to be kept.
  void finish();
  /// The program is ended from outside: writes once more, leaves the file, then calls `then`.
  void leave(std::function<void()> then);

 private:
  QString path() const;
  void tick();

  Session& session_;
  int waited_ = 0;  // ticks
  QString folder_;
  QTimer timer_;
  std::int64_t saved_ = -1;  // steps of the life then
  bool writing_ = false, leaving_ = false, again_ = false;
  QString takenOver_;
  std::unique_ptr<QLockFile> lock_;
};

}  // namespace surefoot
