// SPDX-License-Identifier: GPL-3.0-or-later
// The life that runs on the learner's thread, as the window knows it: its configuration, its newest snapshots, and the
// commands by which a person runs it. Everything here belongs to the window's thread.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "core/experiment/configuration.h"
#include "core/live/learner_thread.h"
#include "ui/running/known_life.h"
#include "ui/running/run_curves.h"

namespace surefoot {

/// The numbers that several places of the window show. All are from one moment: that of the newest curve.
struct Numbers {
  std::int64_t episodes = 0, falls = 0;
  std::int64_t fallsByHand = 0;  ///< falls in episodes where a person placed or pushed the body; part of `falls`
  std::int64_t steps = 0;
  double simulatedSeconds = 0;  ///< NaN: no clock
  double stepsPerSecond = 0;    ///< learning steps per second of wall-clock time, as measured; 0: not yet
};

/// A life that can be saved in the middle of an episode; an error if there is too little memory.
Result<std::unique_ptr<Life>> makeLifeToRun(const Registry& registry, const Configuration& configuration,
                                            bool keepRows);

/// The data of a life if only its configurations are known.
KnownLife knownAs(const Registry& registry, Configuration now, Configuration began);

class RunningLife final : public QObject {
  Q_OBJECT

 public:
  RunningLife(const Registry& registry, Configuration configuration, bool keepRows);
  ~RunningLife() override;

  // The life and its configuration.
  const Registry& registry() const { return registry_; }
  /// The present configuration.
  const Configuration& configuration() const { return known_.configuration; }
  /// The configuration at the life's beginning, with its start.
  const Configuration& began() const { return known_.began; }
  /// "pre-learned (scenario 2)", "with walks.safetensors"; empty: with an empty table.
  QString beginning() const;
  /// Describes and draws the task; it is never stepped.
  const Environment& environment() const { return *environment_; }
  const Task& task() const { return environment_->task(); }
  /// The value of a parameter under the chosen preset and scenario: the value of Reset.
  double base(const std::string& key) const { return known_.base.get(key); }
  /// Whether rows of its episodes are kept for a log.
  bool keepsRows() const { return keepRows_; }

  // The progress of the life.
  const Snapshot& snapshot() const { return learner_->snapshot(); }
  /// The newest snapshot is of this life, not of the one before.
  bool isShown() const { return snapshot().life == lifeSent_; }
  /// nullptr until the first has come.
  const ValueSnapshot* values() const;
  /// Counters, chart, status line, titles and list of falls all show these; they change with valuesArrived, and with
  /// stateChanged, which forgets the speed.
  const Numbers& numbers() const { return numbers_; }
  /// Falls and episodes as of the newest curve.
  CurvePoint latest() const;
  /// How many times faster than real time, as text: "×4,300". Empty where it is not known (yet).
  QString factorText() const;
  /// The step at which a parameter was last changed, if it was.
  std::optional<std::int64_t> changedAt(const std::string& key) const;
  /// The time that schedules depend on.
  LifeTime lifeTime() const;
  /// TRL's threshold now, on its schedule.
  double threshold() const;
  /// The life has reached its limit, or diverged.
  bool finished() const { return isShown() && (snapshot().finished || !snapshot().trouble.empty()); }
  LifeProgress progress() const;
  /// Whether anything was learned here at all, and whether since the last save.
  bool learned() const { return !known_.file.followed && progress().learnedSince({}); }
  bool unsaved() const { return !known_.file.followed && progress().learnedSince(known_.file.saved); }
  /// Memory of the learned values [bytes]; hashed tables grow.
  std::size_t bytes() const;
  /// Curves of this life and of those before it.
  const RunCurves& curves() const { return curves_; }
  RunCurves& curves() { return curves_; }
  /// The falls since the last call, of this life.
  std::vector<Fall> takeFalls();

  // Commands of a person.
  bool running() const { return running_; }
  bool turbo() const { return turbo_; }
  double pace() const { return pace_; }
  void setRunning(bool running);
  void setTurbo(bool turbo);
  void setPace(double pace);
  /// One step of a life that is paused; one that runs is paused first.
  void stepOnce();
  /// Holds the body by its tip [m], or lets go.
  void hold(std::optional<double> target);
  /// Puts the body into a state: a new episode begins there.
  Status place(const std::vector<double>& state);
  /// Goes on in an earlier episode as it stood after these inputs; the life goes on learning there.
  Status goOn(EpisodeInputs until);
  /// Whether the window is visible; a hidden window asks the learner only for the present moment.
  void setLookedAt(bool lookedAt) { lookedAt_ = lookedAt; }

  // Changes; ParameterEditing, History and LifeFiles make them.
  Status setParameter(const std::string& key, double value);
  Status setPolicy(const std::string& name);
  /// The Q-function that can act as guardian (policy.guardian), once a life.
  Status setTeacher(std::shared_ptr<const TensorFile> file);
  /// The names of preset and scenario, which decide the values of Reset.
  void setScenario(const std::string& name);
  const LifeFile& file() const { return known_.file; }
  void setFile(LifeFile file);
  /// Called on the learner's thread, between two steps: the life stands still meanwhile.
  void visit(std::function<void(const Life&)> look);
  /// Watches the life that runs, on the learner's thread, after every step; another life is not watched any more.
  void watch(std::function<Watching(const Life&)> look);
  /// Pushes the body [N s].
  void push(double impulse);
  /// Whether snapshots have every step since the one before, unless the life is in turbo.
  void wantSteps(bool wants);
  /// Counts the lives that ran here.
  std::uint64_t number() const { return lifeSent_; }
  /// Says which life it is, because changes of one life are not undone in another. A life that begins again with
  /// another parameter gets a new number; a life that is brought back keeps its number.
  std::uint64_t lineage() const { return known_.lineage; }
  /// The window's data about this life, up to now.
  KnownLife known() const;
  /// Another life takes its place; `known` is the data about it. Set curves() before.
  void replace(KnownLife known, ReplaceLife replacement);

  /// Ends the learner's thread and returns the life; nullptr if the thread was ended before.
  std::unique_ptr<Life> finish();

 Q_SIGNALS:
  void ticked(double seconds);  ///< about 60 times a second
  void valuesArrived();         ///< at most ten times a second
  void curvesChanged();         ///< earlier curves were added or removed
  void stateChanged();          ///< running, turbo, pace
  void commanded();             ///< a command to run or to pause; comes before stateChanged
  void parameterChanged(const QString& key);
  void policyChanged();
  void configurationChanged();  ///< comes after parameterChanged and policyChanged
  void aboutToBeReplaced();     ///< a visit still meets the life before
  void replaced();              ///< another life runs
  void parametersReplaced();    ///< the life has other names, and so other parameters
  void fileChanged();

 private:
  void tick();
  void takeValues();
  void measureSpeed(double seconds);
  void restartMeasuring();
  bool obeyed() const;  ///< in the newest snapshot the learner has the present pace, turbo and running
  void makeEnvironmentAnew();
  /// Whether its policy's caution can be followed with what this life learns.
  Status checkCaution(const Configuration& changed) const;
  Parameters baseOf(const Names& names) const;

  const Registry& registry_;
  const bool keepRows_;
  KnownLife known_;
  std::unique_ptr<Environment> environment_;
  std::unique_ptr<LearnerThread> learner_;
  RunCurves curves_;
  Numbers numbers_;
  QTimer timer_;
  QElapsedTimer clock_, sinceValues_;
  bool lookedAt_ = true, running_ = false, turbo_ = false, measuring_ = false;
  double pace_ = 1.0, stepsPerSecond_ = 0.0, speedSeconds_ = 0.0;
  std::int64_t stepsBefore_ = 0;
  std::uint64_t lifeSent_ = 1, lifeMeasured_ = 0;
};

}  // namespace surefoot
