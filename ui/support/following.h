// SPDX-License-Identifier: GPL-3.0-or-later
// Looks at a file that another process writes: once a second at its size and time, and into it only when these have
// changed, on a thread of its own. Nothing is ever written there. Whatever happens to the file (gone, cut off, another
// kind), it goes on looking. Belongs to the window's thread.
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/basics/result.h"
#include "ui/support/background.h"

namespace surefoot {

class Following final : public QObject {
  Q_OBJECT

 public:
  /// Takes over what was read, on the window's thread.
  using Take = std::function<void()>;
  struct Look {
    std::vector<std::string> beside;  ///< endings of files that belong to it: "-wal"
    std::function<bool()> isWritten;  ///< whether a process writes it now; called on the other thread; none: unknown
    std::function<Result<Take>(const std::atomic<bool>& interrupted)> read;  ///< on the other thread
  };
  Following(std::string path, Look look, QObject* parent = nullptr);

  /// Ends a following without waiting for what it reads at the moment; nothing is taken over any more. `keeper`, or
  /// who deletes its children, waits at its own end.
  static void end(std::unique_ptr<Following> following, QObject* keeper);

  const std::string& path() const { return path_; }
  /// What was read last was not used: it is read once more.
  void again() { read_.clear(); }
  /// Its name without folders, for people.
  QString name() const;
  /// Why the file's present content is not shown, in a sentence; empty: it is shown.
  QString trouble() const;
  /// The content of the file cannot be shown; a file that is only not there yet is no bad news.
  bool warns() const { return !trouble().isEmpty() && (there_ || isShown()); }
  /// Something of it is shown, be it what it held before.
  bool isShown() const { return modified_.isValid(); }
  bool isWritten() const { return written_; }
  /// When the content that is shown was written: "12:31:05", with the date if it is another day.
  QString lastChange() const;

 Q_SIGNALS:
  void looked();  ///< once a second

 private:
  struct Seen;
  void tick();
  void take(Seen& seen);

  std::string path_;
  Look look_;
  QTimer timer_;
  QElapsedTimer rest_;  // since the last reading
  qint64 restFor_ = 0;  // [ms] after it
  std::string read_;    // the stamp of what was read last
  QString refused_;     // why it could not be
  bool there_ = false, written_ = false;
  QDateTime modified_;
  Background looking_;  // last member: its destructor runs first and waits
};

}  // namespace surefoot
