// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is about: a configuration, the life that runs, and the newest snapshots of it. Turns what a person
// does into commands for the learner's thread, and its snapshots into signals.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <QUndoStack>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/experiment/configuration.h"
#include "core/live/learner_thread.h"
#include "ui/session/background.h"
#include "ui/session/kept_life.h"
#include "ui/session/playback.h"
#include "ui/session/run_curves.h"
#include "ui/session/viewer.h"

namespace surefoot {

/// What is told of a life in several places of the window: all of it of one moment, that of the newest curve.
struct Numbers {
  std::int64_t episodes = 0, falls = 0;
  std::int64_t fallsByHand = 0;  ///< of the falls, those of episodes in which a person placed or pushed the body
  std::int64_t steps = 0;
  double simulatedSeconds = 0;  ///< NaN: no clock
  double stepsPerSecond = 0;    ///< learning steps per second of wall-clock time, as measured; 0: not yet
};

/// What a life can be saved as: to go on exactly, what it learned, or a small text by which it can be lived again.
enum class SavedAs { Session, QFunction, Journal };

class Session final : public QObject {
  Q_OBJECT

 public:
  Session(const Registry& registry, Configuration configuration, bool keepRows, QObject* parent = nullptr);
  ~Session() override;

  const Registry& registry() const { return registry_; }
  const Configuration& configuration() const { return configuration_; }
  /// What the life began with: its start, too.
  const Configuration& began() const { return began_; }
  /// "pre-learned (scenario 2)", "with walks.safetensors"; empty: with an empty table.
  QString beginning() const;
  const Environment& environment() const { return viewer_->environment(); }
  const Task& task() const { return viewer_->environment().task(); }

  const Snapshot& snapshot() const { return learner_->snapshot(); }
  /// nullptr until the first has come.
  const ValueSnapshot* values() const;
  const Shown& shown() const { return shown_; }
  /// The falls of this life, the newest last, up to numbers().falls; of many of them a choice, as thinOut() says.
  const std::deque<Fall>& falls() const { return falls_; }
  /// Shows the last seconds of one of them again.
  void replayFall(std::size_t index);
  /// So many frames back (or forth) in what the window has shown; past the end it is live again.
  void lookBack(int frames);
  /// Something that was seen before is shown; the learner goes on meanwhile.
  const Playback* playback() const { return playback_ ? &*playback_ : nullptr; }
  void seek(double position);
  /// Lets it run, from the beginning if it stands at its end, or stops it.
  void play(bool on);
  void backToLive();
  /// The values that maps show: the newest, or those of the playback. nullptr: none yet.
  const ActionValueFunction* valuesShown() const;
  /// Curves of this life and of those before it.
  const RunCurves& curves() const { return curves_; }

  bool running() const { return running_; }
  bool turbo() const { return turbo_; }
  double pace() const { return pace_; }
  /// Counters, chart, status line, titles and list of falls all show these; they change with valuesArrived, and with
  /// stateChanged, which forgets the speed that was.
  const Numbers& numbers() const { return numbers_; }
  /// Falls and episodes as of the newest curve.
  CurvePoint latest() const;
  double stepsPerSecond() const { return numbers_.stepsPerSecond; }
  /// How many times faster than real time, as text: "×4,300". Empty where it is not known (yet).
  QString factorText() const;
  /// What a parameter is worth under the chosen preset and scenario: what Reset goes back to.
  double base(const std::string& key) const { return base_.get(key); }
  /// The step at which a parameter was last changed, if it was.
  std::optional<std::int64_t> changedAt(const std::string& key) const;
  /// The life has reached its limit, or diverged.
  bool runFinished() const {
    return snapshot().life == lifeSent_ && (snapshot().finished || !snapshot().trouble.empty());
  }

  /// The state that somebody looks at: under the cursor on a map, or fixed there; empty: none but the live one.
  const std::vector<double>& examined() const { return hovered_.empty() ? pinned_ : hovered_; }
  bool pinned() const { return hovered_.empty() && !pinned_.empty(); }
  void examine(const std::optional<std::vector<double>>& state);
  void pin(const std::optional<std::vector<double>>& state);
  /// How far the life has come: what schedules go by.
  LifeTime lifeTime() const;
  /// TRL's threshold now, on its schedule.
  double threshold() const;

  /// Whether anyone can see the window; a hidden one asks the learner for nothing but the moment.
  void setLookedAt(bool lookedAt) { lookedAt_ = lookedAt; }
  void setRunning(bool running);
  void setTurbo(bool turbo);
  void setPace(double pace);
  void stepOnce();
  /// Holds the body of the world that is shown by its tip [m], or lets go.
  void hold(std::optional<double> target);
  /// Puts the learner's world into a state: a new episode begins there.
  Status place(const std::vector<double>& state);
  /// How far the life has come; whether anything was learned in it, and since it was saved.
  LifeProgress progress() const;
  bool learned() const;
  bool unsaved() const;
  /// Where Save writes the life.
  const LifeFile& file() const { return file_; }
  void setFile(LifeFile file);
  /// How far the life had come when save() wrote it last; nothing if that was another one.
  const std::optional<LifeProgress>& written() const { return written_; }

  // What begins a new life: where the tables are large, it is made while the old one goes on, and comes when it is
  // ready; then background() is busy, and what went wrong is said by `refused`. A life that has learned anything is
  // kept: undo brings it back as it was, and redo the new one. Where there is no memory for this, the window is asked.

  /// A new life with the present configuration, the same seed and the same start; the old one stays as a faint curve.
  Status restart();
  /// The same with an empty table.
  Status restartEmpty();
  /// Changes a parameter of the running life, or, if it needs a new table, asks for a restart first (needsNewTable).
  Status setParameter(const std::string& key, double value);
  /// The same, with the new life at once.
  Status setParameterAndRestart(const std::string& key, double value);
  void setPolicy(const std::string& name);
  /// Another learning rule has another table: a new life begins, with every parameter that both know.
  Status setAgent(const std::string& name);
  void setScenario(const std::string& name);
  /// Takes curves of earlier lives out of the charts, by their numbers; undo brings them back.
  void removeEarlierRuns(std::vector<int> numbers);

  using Then = std::function<void(const Status&)>;
  /// Writes the life to a file; `then` is called when it is written, or could not be.
  void save(SavedAs what, const std::string& path, Then then);
  /// A saved session goes on, a Q-function is what a new life begins with, a journal is lived again; `then` is called
  /// when it has begun, or could not.
  void open(const std::string& path, const Then& then);
  /// The present configuration under other names, with every parameter that both know.
  Result<Configuration> configurationUnder(const Names& names) const;
  /// A new life under another configuration.
  Status begin(Configuration configuration);
  /// … in another environment, with its usual parameters.
  Status beginEnvironment(const std::string& name);
  Status setSeed(std::uint64_t seed);
  /// A new life with a parameter that needs a new table, which begins with what was learned, fitted anew.
  void carryOver(const std::string& key, double value, Then then);
  Background& background() { return background_; }
  QUndoStack& undo() { return undo_; }
  /// Use this instead of undo().push(): a life that could be brought back by redo stays within reach of undo.
  void push(QUndoCommand* command);
  /// … and these instead of its own for what is undone in one go.
  void beginMacro(const QString& text);
  void endMacro() { undo_.endMacro(); }
  /// Called before a life ends for good that was not saved; it ends when `goOn` is called. Not set: it ends. `kept`:
  /// one that is kept for undo, of which the memory is needed; nullptr: the one that runs.
  using GoOn = std::function<void()>;
  using Ask = std::function<void(const std::shared_ptr<KeptLife>& kept, const GoOn& goOn)>;
  void setAskBeforeEnding(Ask ask) { askBeforeEnding_ = std::move(ask); }
  const Ask& askBeforeEnding() const { return askBeforeEnding_; }
  /// Memory for lives that undo can bring back [bytes].
  void setMostKept(std::size_t bytes) { mostKept_ = bytes; }
  /// Lives within reach of undo and redo of which something is not saved.
  std::vector<std::shared_ptr<KeptLife>> unsavedBefore() const;
  /// The life that gave way last, if it is kept; which life runs, as undo and redo tell them apart.
  std::shared_ptr<KeptLife> lastKept() const { return kept_.empty() ? nullptr : kept_.back().lock(); }
  std::uint64_t lineage() const { return lineage_; }
  /// Exchanges the life that runs and one that is kept.
  void bringBack(std::shared_ptr<KeptLife>& kept) { exchange(kept); }
  /// Writes one of them.
  void saveKept(const KeptLife& kept, const std::string& path, Then then);

  /// Ends the learner's thread; the life as it is.
  std::unique_ptr<Life> finish();

 Q_SIGNALS:
  void frame();          ///< about 60 times a second
  void valuesArrived();  ///< at most ten times a second
  void curvesChanged();  ///< earlier ones came or went
  void stateChanged();   ///< running, turbo, pace
  void examinedChanged();
  void fallsArrived();
  void playbackChanged();
  void configurationChanged();
  void lifeReplaced();
  void lifeKept();         ///< the life before is within reach of undo
  void lifeBroughtBack();  ///< … and was brought back by undo or redo
  void fileChanged();
  void parametersReplaced();             ///< another agent: other parameters
  void remarked(const QString& remark);  ///< about the file of a life that has begun
  void refused(const QString& why);      ///< a life that was begun could not be made
  void needsNewTable(const QString& key, double value);

 private:
  void tick();
  void show(double seconds);
  void showPlayback(double seconds);
  void takeValues();
  void takeFalls();
  bool copyable() const;  ///< what is learned is small enough to be kept with a fall
  void fillParts(const ActionValueFunction& values);
  void measureSpeed();
  void restartMeasuring();
  bool obeyed() const;  ///< the newest snapshot is of a learner that has heard of pace, turbo, and whether it runs
  struct Beginning {
    Configuration configuration;
    std::unique_ptr<Life> life;
    std::optional<LifeFile> file{};  // that it was read from
    std::string remark{};            // about that file
  };
  using Make = std::function<Result<Beginning>(const std::atomic<bool>& interrupted)>;
  using Adopt = std::function<Status(Beginning)>;
  Status whenMade(Make make, Adopt adopt, const Then& then = {});
  Status beginAgain(Configuration configuration);
  Make makeOf(Configuration configuration) const;
  Make makeOfFile(const std::string& path) const;
  Make makeOfJournal(const std::string& path) const;
  Status beginWithLife(Beginning made);
  void finishOrAsk(std::function<void()> finish);
  Status apply(const std::string& key, double value);
  void makeViewer();
  Result<std::unique_ptr<Life>> makeLifeOf(const Configuration& configuration) const;
  Parameters baseOf(const Names& names) const;
  void adopt(std::unique_ptr<Life> life, std::shared_ptr<KeptLife> before);
  void keepCurves(std::shared_ptr<KeptLife> last);
  void begun(ReplaceLife replacement);
  friend class AnotherLife;
  std::size_t bytesOfLife() const;
  bool canKeep() const;
  std::shared_ptr<KeptLife> withoutRoom(std::size_t more, int lives) const;
  std::shared_ptr<KeptLife> putAside();
  std::shared_ptr<KeptLife> putAsideIfLearned();
  void keep(const std::shared_ptr<KeptLife>& kept);
  void keepForUndo(std::shared_ptr<KeptLife> before);
  void letGo(KeptLife& kept);
  void forgetChanges();
  void exchange(std::shared_ptr<KeptLife>& kept);
  void saveRedone();
  void undoOnceMore(bool redo);

  const Registry& registry_;
  Configuration configuration_;  // as it is now
  Configuration began_;          // as the life began
  Parameters base_;
  bool keepRows_, lookedAt_ = true;
  std::unique_ptr<LearnerThread> learner_;
  std::unique_ptr<Viewer> viewer_;
  Shown shown_;
  std::vector<double> hovered_, pinned_;
  RunCurves curves_;
  std::string curvesIn_;  // the environment of all of them
  Numbers numbers_;
  std::deque<Fall> falls_;
  std::vector<Fall> fallsToCome_;  // newer than the numbers
  /// Of the newest falls, by their numbers.
  std::deque<std::pair<std::int64_t, std::shared_ptr<const ActionValueFunction>>> valuesThen_;
  Recording recording_;
  std::optional<Playback> playback_;
  QUndoStack undo_;
  Background background_;
  QTimer timer_;
  QElapsedTimer sinceValuesThen_, clock_, sinceValues_, sinceFall_;
  bool running_ = false, turbo_ = false, measuring_ = false;
  double pace_ = 1.0;
  double stepsPerSecond_ = 0.0;
  std::int64_t stepsBefore_ = 0, fallsBefore_ = 0;
  double speedSeconds_ = 0.0;
  std::uint64_t lifeSent_ = 1, lifeShown_ = 0;
  LifeFile file_;
  LifeProgress progressKnown_;  // of the life that runs, until its first snapshot
  std::optional<LifeProgress> written_;
  std::size_t bytesOfLife_ = 0, mostKept_ = 600u << 20;
  std::uint64_t lineage_ = 1, lineages_ = 1;  // changes that were made to one life are not undone in another
  std::vector<std::weak_ptr<KeptLife>> kept_;
  Ask askBeforeEnding_;
  bool undoAgain_ = false, keepsBefore_ = true;
};

}  // namespace surefoot
