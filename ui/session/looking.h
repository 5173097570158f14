// SPDX-License-Identifier: GPL-3.0-or-later
// What a person looks at: the world as it is drawn now, falls, the last minutes, a state on a map. None of it touches
// the life.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ui/session/playback.h"
#include "ui/session/running_life.h"
#include "ui/session/viewer.h"

namespace surefoot {

/// The falls of a life, the newest last, and the values at some of them, by the falls' numbers.
struct SeenFalls {
  std::deque<Fall> falls;
  std::deque<std::pair<std::int64_t, std::shared_ptr<const ActionValueFunction>>> values;
};

class Looking final : public QObject {
  Q_OBJECT

 public:
  explicit Looking(RunningLife& life);

  const Shown& shown() const { return shown_; }
  /// The values that maps show: the newest, or those of the playback. nullptr: none yet.
  const ActionValueFunction* valuesShown() const;
  /// Holds the body of the world that is shown by its tip [m], or lets go.
  void hold(std::optional<double> target);

  /// The falls of this life, the newest last, up to the life's numbers().falls; of many of them a choice, as thinOut()
  /// says.
  const std::deque<Fall>& falls() const { return seen_.falls; }
  /// Shows the last seconds of one of them again.
  void replayFall(std::size_t index);

  /// So many frames back (or forth) in what the window has shown; past the end it is live again.
  void lookBack(int frames);
  /// The next frame where something stands that was seen before; else one step of the life.
  void stepOnce();
  /// Something that was seen before is shown; the learner goes on meanwhile.
  const Playback* playback() const { return playback_ ? &*playback_ : nullptr; }
  void seek(double position);
  /// Lets it run, from the beginning if it stands at its end, or stops it.
  void play(bool on);
  void backToLive();

  /// The state that is examined: under the cursor on a map, or fixed there; empty: none but the live one.
  const std::vector<double>& examined() const { return hovered_.empty() ? pinned_ : hovered_; }
  bool pinned() const { return hovered_.empty() && !pinned_.empty(); }
  void examine(const std::optional<std::vector<double>>& state);
  void pin(const std::optional<std::vector<double>>& state);

  /// What was seen of the life, to be kept with it, …
  SeenFalls seen() const;
  /// … and what was seen of the one that takes its place, before it does.
  void setSeen(SeenFalls seen) { seen_ = std::move(seen); }

 Q_SIGNALS:
  void frame();  ///< shown() is new: about 60 times a second
  void examinedChanged();
  void fallsArrived();
  void playbackChanged();

 private:
  void advance(double seconds);
  void show(double seconds);
  void showPlayback(double seconds);
  void takeFalls();
  bool copyable() const;  ///< what is learned is small enough to be kept with a fall
  void fillParts(const ActionValueFunction& values);
  void makeViewer();
  void beginAnew();

  RunningLife& life_;
  std::unique_ptr<Viewer> viewer_;
  Shown shown_;
  std::vector<double> hovered_, pinned_;
  SeenFalls seen_;
  std::vector<Fall> fallsToCome_;  // newer than the numbers
  Recording recording_;
  std::optional<Playback> playback_;
  QElapsedTimer sinceValues_, sinceFall_;
  std::int64_t fallsBefore_ = 0;
  std::uint64_t lifeShown_ = 0;
};

}  // namespace surefoot
