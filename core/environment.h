// SPDX-License-Identifier: GPL-3.0-or-later
// A world with a task, in which a learner acts.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/basics/random.h"
#include "core/basics/types.h"
#include "core/parameters.h"
#include "core/scene.h"

namespace surefoot {

/// One coordinate of the state.
struct StateVariable {
  std::string key{};                     ///< "pole_angle": also the name of its resolution, features.pole_angle
  std::string title{};                   ///< "pole angle"
  std::string symbol{};                  ///< "α"; a dot above is U+0307 behind the letter
  std::string unit{};                    ///< "rad"
  double low = 0.0, high = 1.0;          ///< the range that features cover; states outside count as at the edge
  double span = 1.0;                     ///< a resolution is the number of tiles per span (thesis, section 3.1.3)
  std::string spanText{};                ///< "2π rad": the span as a person says it
  std::string perSpan{};                 ///< "/2π": the unit of a resolution, short
  double resolution = 1.0;               ///< default number of tiles per span
  std::optional<double> period{};        ///< the variable wraps after this much; none: it does not
  bool whole = false;                    ///< takes whole numbers only: it fits a table
  double viewLow = 0.0, viewHigh = 0.0;  ///< the part that a map shows at first
};

/// One coordinate of the action, where an action is a combination of several: every combination of the levels is an
/// action, the last variable counting fastest.
struct ActionVariable {
  std::string key{};     ///< "swing_hip_voltage": also the name of its resolution, features.swing_hip_voltage
  std::string title{};   ///< "swing hip voltage"
  std::string symbol{};  ///< "U"
  std::string unit{};    ///< "V"
  std::vector<double> levels{};
  double resolution = 1.0;  ///< default number of tiles per unit: actions that are near share what they learn
};

/// A measure of an episode besides reward and falls, for example the distance walked. Logs, results, stores, tables and
/// plans take it from here.
struct TaskMeasure {
  /// What it is for a whole life: a value of all its episodes.
  enum class OfALife { Sum, Mean, Last, Largest };
  std::string key{};    ///< "distance"
  std::string title{};  ///< "distance"
  std::string unit{};   ///< "m"
  OfALife ofALife = OfALife::Sum;
};

/// Everything that is known of a task before it starts.
struct Task {
  std::vector<StateVariable> state;
  std::vector<double> actions;                      ///< the physical value of every action, e.g. a torque in N m
  std::vector<std::string> actionNames{};           ///< names where a number says too little: "up"
  std::vector<ActionVariable> actionVariables{};    ///< where an action is a combination; empty: it is one number
  std::string actionTitle;                          ///< "torque"
  std::string actionSymbol;                         ///< "T"
  std::string actionUnit;                           ///< "N m"
  std::vector<std::string> rewardTerms;             ///< names of Outcome::terms, in their order
  std::optional<double> goalReward{};               ///< reward of a success, if the task has one
  double timeReward = 0.0;                          ///< reward of every step
  std::vector<TaskMeasure> measures{};              ///< at most kMaxMeasures
  int testEvery = 0;                                ///< episodes between two tests of the greedy policy; 0: none
  std::optional<double> stepTime{};                 ///< [s] simulated per step; none: the task has no clock
  bool handMade = false;                            ///< step() knows kHandMade
  bool canFall = true;                              ///< an event can be a fall; else only successes are counted
  double lowestReturn = -1.0, highestReturn = 1.0;  ///< bounds of an episode's reward, if any: axes start there
};

/// The place of a measure in Task::measures, if the task has it.
std::optional<std::size_t> measureAt(const std::vector<TaskMeasure>& measures, std::string_view key);

/// Which level of an action variable an action has.
std::size_t levelOf(const Task& task, std::size_t action, std::size_t variable);
/// Action `a` in physical units, one value per action variable: {0.75} [N m], {-8.9, 0, 8.9} [V].
std::vector<double> actionValues(const Task& task, std::size_t a);
/// The action with these levels of the action variables.
Action actionOf(const Task& task, std::span<const std::size_t> levels);
/// The place of the level that is nearest to a value; of two, the first.
std::size_t nearestLevel(std::span<const double> levels, double value);

/// Whether these are values of all state variables, each within its range; a sentence that names the first that is not.
Status checkState(const Task& task, std::span<const double> state);

/// A quantity of the world that is no part of the state: a contact, a power. For those who look.
struct Signal {
  enum class Kind { Number, OnOff };
  std::string key{};     ///< "left_foot": its column in tables
  std::string title{};   ///< "left foot on the floor"
  std::string symbol{};  ///< "T"; empty: none
  std::string unit{};    ///< "N m"
  std::string group{};   ///< "motion", "motors", "contacts" …
  Kind kind = Kind::Number;
};

/// A number that the window shows below the picture.
struct ReadOut {
  std::string symbol, unit;
  double value = 0.0;
  int decimals = 2;
};

/// Used by one thread at a time. Only the calls marked "hot" are made in the learning loop; they neither allocate nor
/// lock. All randomness comes from the generator that is handed in.
class Environment : public Configurable {
 public:
  virtual const Task& task() const = 0;

  /// Starts an episode in a state drawn from the start distribution.
  virtual void reset(Random& random) = 0;
  /// Carries out one action; reset() first, and again after an ending. Hot.
  virtual Outcome step(Action action) = 0;
  /// The state now; the view is valid until the next call. Hot.
  virtual std::span<const double> state() const = 0;

  /// The values of Task::measures for the episode up to now (a sum, a mean, a position …): all begin anew with reset()
  /// and place(). Valid until the next call.
  virtual std::span<const double> measures() const { return {}; }

  /// What moves besides the state, in the order of readSignals(); it does not change while the environment lives.
  virtual std::vector<Signal> signals() const { return {}; }
  /// values ← the signals after the last step; an on/off signal is 0 or 1. Looking changes nothing.
  virtual void readSignals(std::span<double> values) const { static_cast<void>(values); }

  /// Why no further episode is possible, in one sentence; empty: it is. Asked when an episode has ended.
  virtual std::string failure() const { return {}; }
  /// Whether reset() and step() take no time that a person would notice; false: a window waits for them elsewhere.
  virtual bool answersAtOnce() const { return true; }
  /// Why the last reset() or step() did not happen, in one sentence; empty: it did. It can be tried again; a reset()
  /// that did not happen has left the generator as it was.
  virtual std::string unanswered() const { return {}; }
  /// Of episodes that were cut off because the world came to numbers that are none, or are beyond all bounds.
  struct CutOffs {
    std::int64_t all = 0, inARow = 0;
  };
  virtual CutOffs cutOffs() const { return {}; }
  /// A saved life goes on: these happened before.
  virtual void setCutOffs(const CutOffs& before) { static_cast<void>(before); }

  /// The action that is nearest to what the hand-made controller would do now; only for tasks with Task::handMade. Hot.
  virtual Action handMadeAction() const { return kNoAction; }

  /// Pushes the body to the right by an impulse [N s], between two steps; false: there is no body to push.
  virtual bool push(double impulse) {
    static_cast<void>(impulse);
    return false;
  }
  /// Begins an episode in a given state, in place of a reset; false: this cannot be done. The state has the right
  /// length and lies within the ranges of its variables.
  virtual bool place(std::span<const double> state) {
    static_cast<void>(state);
    return false;
  }
  /// A pose in which the state is this one, for a picture; empty: there is none.
  virtual std::vector<double> poseAt(std::span<const double> state) const {
    static_cast<void>(state);
    return {};
  }

  /// Everything that a picture needs and the state leaves out (the position of a cart), and the last action's value.
  virtual std::vector<double> pose() const = 0;
  /// Draws a pose of this environment.
  virtual void draw(std::span<const double> pose, Scene& scene) const = 0;
  /// The numbers below the picture.
  virtual std::vector<ReadOut> readOuts(std::span<const double> pose) const = 0;

  /// Whether the parameters fit together, which their ranges alone cannot say. The error names the keys.
  virtual Status check() const { return Done{}; }
  /// Parameters were changed through declare(): from here on they hold. Called between two episodes.
  virtual void parametersChanged() {}
};

}  // namespace surefoot
