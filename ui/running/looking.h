// SPDX-License-Identifier: GPL-3.0-or-later
// The things that a person looks at: the world as it is drawn now, falls, the last minutes, a state on a map. Looking
// never changes the life.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <atomic>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "ui/running/playback.h"
#include "ui/running/running_life.h"
#include "ui/running/signal_feed.h"
#include "ui/running/viewer.h"

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
  /// The values that maps show: the newest, or the values of the playback. nullptr: none yet.
  const ActionValueFunction* valuesShown() const;
  /// While the life rests, the world goes on in real time by what was learned so far, and nothing is learned.
  void setDemonstrating(bool on) { demonstrating_ = on; }
  /// Whether a second world can be shown in real time.
  bool hasViewer() const { return viewer_->environment().answersAtOnce(); }
  bool demonstrating() const { return demonstrating_; }
  /// Holds the body of the world that is shown by its tip [m], or lets go.
  void hold(std::optional<double> target);

  /// The falls of this life, the newest last, up to the life's numbers().falls. If there are many, thinOut() keeps only
  /// some of them.
  const std::deque<Fall>& falls() const { return seen_.falls; }
  /// Shows the last seconds of one of them again.
  void replayFall(std::size_t index);
  /// The same, slower, and not by a person: a lesson shows the last one.
  void showLastFall();

  /// Goes back (or forth) by some frames that the window has shown; past the end it is live again.
  void lookBack(int frames);
  /// The next frame of a stopped playback; without one, one step of the life.
  void stepOnce();
  /// The playback that is shown, if any; the learner goes on meanwhile.
  const Playback* playback() const { return playback_ ? &*playback_ : nullptr; }
  /// The last minutes that the window has shown, for a film; their signals are recordedSignals().
  Footage recorded() const { return recording_.footage(feed_.first()); }
  const SignalTable& recordedSignals() const { return feed_.table(); }
  void seek(double position);
  /// Plays it (from the beginning if it is at its end), or stops it.
  void play(bool on);
  void backToLive();
  /// The episode of the playback up to the moment that is shown: what a life can go on with. Refused where that is not
  /// known, or the model was another one then.
  Result<EpisodeInputs> momentShown() const;
  /// The life went on from another moment: what is written down begins anew.
  void wentOn();

  // Signals, written down while somebody watches them.
  void watchSignals(const QObject* who, bool watches);
  /// Of the playback, or of the last minutes of the world that is shown.
  const SignalTable& signals() const { return playback_ ? playback_->signals : feed_.table(); }
  /// The row of the moment that is shown; none: nothing was written down of it.
  std::optional<std::size_t> signalRow() const;
  /// Shows the moment of a row: in the playback, or going back to it.
  void seekRow(std::size_t row);
  /// What the greedy policy does from a new start, as a playback; a sentence where this cannot be.
  Status rollOut(double seconds);
  /// Signals are the learner's own, or were: not a roll-out's, a fall's, or those of a second world in turbo.
  bool showsLearner() const { return !feedOfViewer_ && !(playback_ && playback_->start); }
  /// Another Q-function beside the first, in every playback that can be lived from its start; null: none. `path`: its
  /// file, if it has one.
  void setSecond(std::shared_ptr<const ActionValueFunction> values, const QString& name, const QString& path = {});
  const QString& secondName() const { return secondName_; }
  const QString& secondPath() const { return secondPath_; }
  bool hasSecond() const { return second_ != nullptr; }
  /// Its signals in this playback; no rows: there are none.
  const SignalTable& secondSignals() const { return secondSignals_; }

  /// The state that is examined: under the cursor on a map, or fixed there; empty: none but the live one.
  const std::vector<double>& examined() const { return hovered_.empty() ? pinned_ : hovered_; }
  bool pinned() const { return hovered_.empty() && !pinned_.empty(); }
  /// The state that is fixed on the maps; empty: none.
  const std::vector<double>& pinnedState() const { return pinned_; }
  void examine(const std::optional<std::vector<double>>& state);
  void pin(const std::optional<std::vector<double>>& state);

  /// In a playback: what was shown when the action was chosen that is carried out now; nullptr: it is not known.
  const Shown* whenChosen() const;
  /// The falls and values seen in this life, to be kept with it.
  SeenFalls seen() const;
  /// Sets the falls and values of the next life; called before that life takes the place of this one.
  void setSeen(SeenFalls seen) { seen_ = std::move(seen); }

 Q_SIGNALS:
  void frame();  ///< shown() is new: about 60 times a second
  void examinedChanged();
  void fallsArrived();
  void playbackChanged();
  void signalsReplaced();                   ///< signals() or secondSignals() are others than before
  void held(std::optional<double> target);  ///< a person holds the body there, or lets go
  void fallReplayed(std::int64_t episode);  ///< a person looks at the fall of this episode again

 private:
  void advance(double seconds);
  void show(double seconds);
  void showPlayback(double seconds);
  void takeFalls();
  bool showFall(std::size_t index);
  bool copyable() const;  ///< the values are small enough to be kept with a fall
  void fillParts(const ActionValueFunction& values);
  void makeViewer();
  void writeSignals(bool viewing);
  void askForEpisodeInHand();
  Result<EpisodeInputs> recordedMoment() const;
  void begin(Playback playback);
  void beginAnew();

  RunningLife& life_;
  std::unique_ptr<Viewer> viewer_;
  Shown shown_;
  std::vector<double> hovered_, pinned_;
  SeenFalls seen_;
  std::vector<Fall> fallsToCome_;  // newer than life_.numbers()
  Recording recording_;
  std::optional<Playback> playback_;
  SignalFeed feed_;
  std::set<const QObject*> watching_;
  bool feedOfViewer_ = false;
  std::shared_ptr<const ActionValueFunction> second_;
  QString secondName_, secondPath_;
  SignalTable secondSignals_;
  /// The episode that the life was in when the recording was opened, filled on the learner's thread.
  struct InHand {
    std::atomic<bool> ready = false;
    EpisodeInputs inputs;
    std::int64_t begun = 0;  ///< steps of the life before it
  };
  std::shared_ptr<InHand> inHand_;
  QElapsedTimer sinceValues_, sinceFall_;
  std::int64_t fallsBefore_ = 0;
  std::uint64_t lifeShown_ = 0;
  bool demonstrating_ = false;
};

}  // namespace surefoot
