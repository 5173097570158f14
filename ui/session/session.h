// SPDX-License-Identifier: GPL-3.0-or-later
// All data of the window, in parts for the things that people do. A panel gets only the parts that it needs.
#pragma once

#include "ui/running/looking.h"
#include "ui/running/running_life.h"
#include "ui/session/editing.h"
#include "ui/session/history.h"
#include "ui/session/life_files.h"
#include "ui/session/new_lives.h"

namespace surefoot {

class Session final {
 public:
  Session(const Registry& registry, Configuration configuration, bool keepRows)
      : life_(registry, std::move(configuration), keepRows) {}
  /// The learner's thread ends first, because its tasks use the parts.
  ~Session() { life_.finish(); }

  /// The life that runs: its configuration and progress, run and pause.
  RunningLife& life() { return life_; }
  const RunningLife& life() const { return life_; }
  /// The things on view: the world that is drawn, falls, the last minutes, a state on a map.
  Looking& looking() { return looking_; }
  /// Undo and redo, and the lives that they bring back.
  History& history() { return history_; }
  /// Changes of the life that runs.
  Editing& editing() { return editing_; }
  /// Begins other lives.
  NewLives& newLives() { return newLives_; }
  LifeFiles& files() { return files_; }

 private:
  RunningLife life_;
  Looking looking_{life_};  // made first, so that it gets signals first: the others read it when they get theirs
  History history_{life_, looking_};
  Editing editing_{life_, history_};
  NewLives newLives_{life_, history_};
  LifeFiles files_{life_, newLives_};
};

}  // namespace surefoot
