// SPDX-License-Identifier: GPL-3.0-or-later
// A life on a thread of its own. Commands go in through a mailbox and are carried out between two steps; snapshots come
// out through triple buffers, filled only when asked for. Snapshots change nothing: the life takes the same course, bit
// for bit, however often they are asked for.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "core/life/fall.h"
#include "core/life/hand.h"
#include "core/live/snapshot.h"
#include "core/live/triple_buffer.h"

namespace surefoot {

struct SetParameter {
  std::string key;
  double value;
};
struct SetPolicy {
  std::string name;
  std::unique_ptr<Policy> policy;
};
struct SetTeacher {
  std::unique_ptr<Agent> teacher;
};  ///< its Q-function can act as guardian from now on
struct SetRunning {
  bool running;
};
struct SetPace {
  double pace;
};  ///< times real time, while turbo is off
struct SetTurbo {
  bool turbo;
};
struct SetHand {
  std::optional<double> target;
};  ///< where the body's tip is held [m]; empty: the hand lets go
struct Place {
  std::vector<double> state;
};  ///< a new episode there
struct GoOn {
  EpisodeInputs until;
};  ///< an earlier episode, as it stood after these inputs
struct Visit {
  std::function<void(const Life&)> look;
};                     ///< called on the learner's thread, between two steps
struct SingleStep {};  ///< one step of a paused life
enum class Watching { GoOn, Enough, EnoughAndPause };
/// Called on the learner's thread after every step of this life, until it has seen enough; then it is dropped, and the
/// life pauses or goes on. Empty: nobody watches.
struct Watch {
  std::function<Watching(const Life&)> look;
};
struct Push {
  double impulse;  ///< [N s]
};
/// A life that was taken out of the thread, with the thread's data about it: it can go on there later, bit for bit.
/// Filled and emptied on the learner's thread; other threads may only keep or drop the pointer.
struct LifeAside {
  std::unique_ptr<Life> life;  ///< null before the thread has come to it, and when the life runs again
  LearningCurve curve;
  std::string curvePolicy;
  std::vector<double> fallenPose;
  std::int64_t fallsByHand = 0;
};
struct ReplaceLife {
  std::unique_ptr<Life> life{};         ///< a new one …
  std::shared_ptr<LifeAside> back{};    ///< … or one that was put aside
  std::shared_ptr<LifeAside> before{};  ///< where the life before goes; null: it ends
  StepTaken last{};                     ///< the last step of the new one, if it is known
};

using Command = std::variant<SetParameter, SetPolicy, SetTeacher, SetRunning, SetPace, SetTurbo, SetHand, Place, GoOn,
                             Visit, SingleStep, Watch, Push, ReplaceLife>;

/// send(), wantSnapshot(), takeSnapshot() … are for one thread, the window's; the life belongs to the thread in here.
class LearnerThread {
 public:
  explicit LearnerThread(std::unique_ptr<Life> life);
  ~LearnerThread();
  LearnerThread(const LearnerThread&) = delete;

  void send(Command command);

  /// Asks for a fresh snapshot; take…() tells whether one has come, snapshot() is the newest taken.
  void wantSnapshot() { want(snapshotWanted_); }
  void wantValues() { want(valuesWanted_); }
  /// Whether snapshots have every step since the one before, unless the life is in turbo.
  void wantSteps(bool wants) { stepsWanted_ = wants; }
  bool takeSnapshot() { return snapshots_.take(); }
  bool takeValues() { return values_.take(); }
  const Snapshot& snapshot() const { return snapshots_.front(); }
  const ValueSnapshot& values() const { return values_.front(); }

  /// The falls since the last call, the newest last; at most kMostFalls, thinned out as thinOut() says.
  std::vector<Fall> takeFalls();

  /// Ends the thread and returns its life; nullptr if this was done before.
  std::unique_ptr<Life> stop();

 private:
  using Clock = std::chrono::steady_clock;

  void run();
  void lifeOn();
  void beginLife();
  /// Whether the environment answered; a life that waits for it stands still.
  bool noteAnswer();
  void wait();
  void obey();
  void carryOut(Command& command);
  void replace(ReplaceLife& command);
  void stepFlatOut();
  void stepInPace();
  void step();
  void noteEpisode();
  void noteFall();
  void beWatched();
  /// A life whose environment did not answer does not run, and tries it again when it is told to.
  bool isOver() const { return life_->finished() && life_->unanswered().empty(); }
  bool canStep() const { return running_ && trouble_.empty() && !isOver(); }
  void want(std::atomic<bool>& flag);
  void answer();
  StepSeen stepToCome() const;
  void fill(Snapshot& snapshot);
  void fill(ValueSnapshot& snapshot) const;
  void fillTests(ValueSnapshot& snapshot) const;

  // The thread's own.
  std::unique_ptr<Life> life_;
  std::uint64_t lifeNumber_ = 1;
  LearningCurve curve_;
  std::string curvePolicy_;
  std::int64_t fallsByHand_ = 0;
  std::vector<double> fallenPose_;
  Hand hand_;
  std::function<Watching(const Life&)> watch_;
  StepTaken last_;
  std::vector<StepSeen> seen_;     // since the last snapshot that was fetched
  std::size_t seenPublished_ = 0;  // of these, those in a snapshot already
  std::size_t changesSeen_ = 0;
  int looksLeft_ = 0;
  std::shared_ptr<const std::vector<std::pair<std::string, double>>> environment_;  // parameters at the last fall
  bool mustBegin_ = true;                                                           // the life in hand
  bool running_ = false, turbo_ = false;
  std::int64_t unansweredTries_ = 0;
  std::string trouble_;  // why the life stands still: an exception was thrown
  double pace_ = 1.0;
  double stepTime_;  // [s]; tasks without a clock take 20 steps a second
  Clock::time_point nextStep_{};

  // Shared.
  std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<Command> mailbox_;  // guarded by mutex_
  std::vector<Fall> falls_;       // guarded by mutex_
  std::atomic<bool> mail_{false}, stop_{false};
  std::atomic<bool> snapshotWanted_{true}, valuesWanted_{true}, stepsWanted_{false};
  TripleBuffer<Snapshot> snapshots_;
  TripleBuffer<ValueSnapshot> values_;

  std::thread thread_;
};

}  // namespace surefoot
