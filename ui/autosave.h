// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the session on the disk while the window is open, so that a crash loses a minute at most. The file is named
// after the process; one whose process is gone was left by a crash.
#pragma once

#include <QObject>
#include <QTimer>

namespace surefoot {

class Session;

class Autosave final : public QObject {
  Q_OBJECT

 public:
  static constexpr int kEvery = 60'000;  ///< [ms]
  Autosave(Session& session, QString folder, QObject* parent = nullptr);
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
