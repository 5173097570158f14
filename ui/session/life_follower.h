// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the life of a checkpoint that another process writes again and again (`train --checkpoint FILE`), as it is in
// the file now: a life that stands still, to be looked at. The body acts with its values in a world of its own, and
// learns nothing. The file is never written. Whatever makes the life go on here, or changes it (run, a step, a
// parameter), makes it a life of one's own, and ends the following. Belongs to the window's thread.
#pragma once

#include <QObject>
#include <memory>

#include "ui/session/session.h"
#include "ui/support/following.h"

namespace surefoot {

class LifeFollower final : public QObject {
  Q_OBJECT

 public:
  explicit LifeFollower(Session& session, QObject* parent = nullptr);
  /// The life that runs is kept for undo when the first state of the file is shown.
  void follow(const std::string& path);
  /// The life stays where it is, as one of one's own.
  void stop();
  /// The same, and it goes on.
  void goOn();
  /// nullptr: nothing is followed.
  const Following* following() const { return following_.get(); }
  /// How the life stands, in words.
  QString text() const;

 Q_SIGNALS:
  void changed();                           ///< once a second while something is followed, and at its end
  void becameOnesOwn(const QString& name);  ///< the file is not followed any more

 private:
  void take(NewLives::Made made);
  void begin(NewLives::Made made);
  void renew(NewLives::Made made);
  void lifeReplaced();
  void watch();

  Session& session_;
  std::unique_ptr<Following> following_;
  std::uint64_t shown_ = 0;  // number of the life that is the file's; 0: none yet
  std::int64_t steps_ = 0;   // that it has made in the file
  bool beginning_ = false;   // the first is being begun, perhaps asked about
  bool missed_ = false;      // the file changed meanwhile
  bool renewing_ = false;
};

}  // namespace surefoot
