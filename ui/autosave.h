// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the session on the disk while the window is open, so that a crash loses little. The file is named
// after the process; one whose process is gone was left by a crash.
#pragma once

#include <QObject>
#include <QTimer>

namespace surefoot {

class Session;

class Autosave final : public QObject {
  Q_OBJECT

 public:
  /// Once a minute, until it is told otherwise.
  Autosave(Session& session, QString folder, QObject* parent = nullptr);
  void setMinutes(int minutes) { timer_.setInterval(minutes * 60'000); }
  /// What a crash left, the newest; empty: nothing.
  QString leftBehind() const;
  /// Removes what crashes left.
  void forget();
  /// Writes now, if the life has moved since.
  void save();
  /// The window was closed properly: nothing needs to be kept.
  void finish();

 private:
  QString path() const;

  Session& session_;
  QString folder_;
  QTimer timer_;
  std::int64_t saved_ = -1;  // steps of the life then
  bool writing_ = false;
};

}  // namespace surefoot
