// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is about, in parts by what people do. A panel gets the parts that it needs.
#pragma once

#include "ui/session/editing.h"
#include "ui/session/history.h"
#include "ui/session/life_files.h"
#include "ui/session/looking.h"
#include "ui/session/new_lives.h"
#include "ui/session/running_life.h"

namespace surefoot {

class Session final {
 public:
  Session(const Registry& registry, Configuration configuration, bool keepRows)
      : life_(registry, std::move(configuration), keepRows) {}
  /// The learner's thread ends first: what it was asked to do speaks to the parts.
  ~Session() { life_.finish(); }

  /// The life that runs: what it is, how far it has come, run and pause.
  RunningLife& life() { return life_; }
  const RunningLife& life() const { return life_; }
  /// What is looked at: the world that is drawn, falls, the last minutes, a state on a map.
  Looking& looking() { return looking_; }
  /// What is undone, and the lives that undo brings back.
  History& history() { return history_; }
  /// Changes of the life that runs.
  Editing& editing() { return editing_; }
  /// What begins another life.
  NewLives& newLives() { return newLives_; }
  LifeFiles& files() { return files_; }

 private:
  RunningLife life_;
  Looking looking_{life_};  // the first to hear of anything: others read it when they hear of it
  History history_{life_, looking_};
  Editing editing_{life_, history_};
  NewLives newLives_{life_, history_};
  LifeFiles files_{life_, newLives_};
};

}  // namespace surefoot
