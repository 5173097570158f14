// SPDX-License-Identifier: GPL-3.0-or-later
// One agent in one environment from its first step on: "run" in Sutton & Barto, "life" in the thesis.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/agent.h"
#include "core/basics/random.h"
#include "core/basics/result.h"
#include "core/environment.h"
#include "core/life/episode_inputs.h"
#include "core/life/episode_log.h"
#include "core/life/greedy_trial.h"
#include "core/life/guardians.h"
#include "core/life/rewinding.h"

namespace surefoot {

/// A life remembers at most this many changes: a slider dragged for an hour must not fill the memory.
inline constexpr std::size_t kMostChanges = 10'000;

/// Something was done to a life while it went on.
struct Change {
  std::int64_t step = 0;      ///< steps of the life before it
  std::string key;            ///< a parameter's key, or "policy", "push", "place", "go_on"
  std::string before, after;  ///< as a person writes them
};

/// Something to be done to a life when it has taken so many steps: a parameter to set, a policy to follow, a push [N
/// s], a state to be placed in, an episode to go on with.
struct TimedCommand {
  std::int64_t step = 0;
  std::string key;
  double value = 0.0;
  std::unique_ptr<Policy> policy;  ///< for the key "policy"
  std::string policyName;
  std::vector<double> state{};  ///< for the key "place"
  EpisodeInputs until{};        ///< for the key "go_on"
};

struct LifeParts {
  std::unique_ptr<Environment> environment;
  std::unique_ptr<Policy> policy;
  std::unique_ptr<Agent> agent;
  Parameters parameters;  ///< complete; the parts were made from it
  std::string policyName;
  std::vector<TimedCommand> commands;    ///< in the order of their steps
  bool preLearned = false;               ///< it begins with something learned before
  std::vector<Change> changes{};         ///< the changes so far, of a life that goes on
  std::unique_ptr<Environment> tests{};  ///< another environment, for tests of the greedy policy; null: none
  std::uint64_t testSeed = 0;
  std::unique_ptr<Agent> teacher{};  ///< its Q-function can act as guardian; null: none
};

/// The limit that is reached first ends the life.
struct LifeLimits {
  std::int64_t episodes = std::numeric_limits<std::int64_t>::max();
  std::int64_t steps = std::numeric_limits<std::int64_t>::max();
  double averageReward = kInfinity;  ///< the mean of 80 episodes that ends the life
};

/// Used by one thread at a time.
class Life {
 public:
  Life(LifeParts parts, Random world, Random policy, LifeLimits limits, bool keepRows);
  /// A saved life goes on: the parts are made from the file's description (checkpoint.h), the rest is read from the
  /// archive. The archive's status says whether that succeeded.
  Life(LifeParts parts, LifeLimits limits, bool keepRows, Archive& archive);

  /// The constructor begins the first episode, or takes the environment to where a saved life was, unless the
  /// environment takes its time: then this does, or the first step. unanswered() tells whether it could be done.
  void begin();
  /// One decision: the environment answers the action, the agent learns and chooses the next. Hot. `giveUp`, which may
  /// be set by any thread: a test of the greedy policy in an environment that takes its time is given up, and made
  /// again by the next step.
  void step(const std::atomic<bool>* giveUp = nullptr);
  /// A limit is reached, or the values diverged: step() must not be called any more. Or the environment did not answer
  /// (see unanswered()).
  bool finished() const {
    const bool reached =
        steps_ >= limits_.steps || log_.totals().episodes >= limits_.episodes || reachedAverage() || diverged();
    return !unanswered_.empty() || (reached && !owesTest());
  }
  /// Why the environment did not answer: the last step, reset or test did not happen. The next step() tries it again.
  /// Empty: it did.
  const std::string& unanswered() const { return unanswered_; }
  /// The values diverged, or the environment can not go on.
  bool diverged() const { return agent_->diverged() || !failure_.empty(); }
  /// One sentence naming the parameter that most likely made the values diverge, or what the environment says.
  std::string divergence() const;

  /// Changes one parameter: at once, or at the next episode, as it declares. A parameter that needs a new table is
  /// refused: make a new life for it.
  Status set(std::string_view key, double value);
  void setPolicy(const std::string& name, std::unique_ptr<Policy> policy);
  /// From now on this agent's Q-function is the one that can act as guardian (policy.guardian).
  void setTeacher(std::unique_ptr<Agent> teacher);
  /// Pushes the body by an impulse [N s]; false: there is none to push.
  bool push(double impulse);
  /// Gives up the current episode, which is then not counted, and begins one in this state.
  Status place(const std::vector<double>& state);
  /// Gives up the current episode, which is then not counted, and goes on in another one as it stood after these
  /// inputs: the world is taken through it again, exactly, and its random numbers go on as they did then. What was
  /// lived before that moment is not learned or counted again. Refused, and a new episode begins, where the world of
  /// now ends before that moment.
  Status goOn(const EpisodeInputs& until);

  /// From now on remembers the environment's inputs in the current episode, so that the life can be saved in the middle
  /// of an episode. Call it before the first step.
  void keepInputs() { keepInputs_ = true; }
  /// Writes the whole state of the life to a file; the inputs must have been kept. (The constructor reads it.)
  void save(Archive& archive) const;
  /// The environment's parameters in force in this episode; parameters() may hold newer values.
  std::vector<std::pair<std::string, double>> environmentInForce() const;

  const Environment& environment() const { return *environment_; }
  const Agent& agent() const { return *agent_; }
  const Policy& policy() const { return *policy_; }
  const std::string& policyName() const { return policyName_; }
  const Parameters& parameters() const { return parameters_; }
  const EpisodeLog& log() const { return log_; }
  /// Takes the rows kept so far out of the log; a later checkpoint has only later rows.
  std::vector<EpisodeRow> takeRows() { return log_.takeRows(); }
  const std::vector<Change>& changes() const { return changes_; }
  const std::vector<GreedyTest>& greedyTests() const { return tester_.tests(); }
  /// CPU time of the greedy tests that this process made [s].
  double testSeconds() const { return tester_.cpuSeconds(); }
  /// More was changed than changes() holds.
  bool changesLeftOut() const { return changesLeftOut_; }
  const LifeLimits& limits() const { return limits_; }

  bool preLearned() const { return preLearned_; }
  std::int64_t steps() const { return steps_; }
  /// [s]; NaN where the task has no clock.
  double simulatedSeconds() const;
  /// What the last step brought.
  const Outcome& outcome() const { return outcome_; }
  /// The action that the next step will carry out.
  Action nextAction() const { return action_; }
  bool inEpisode() const { return inEpisode_; }
  /// Inputs of the current episode, or of the last one when it is over; complete only if they are kept.
  const EpisodeInputs& inputs() const { return inputs_; }
  /// Whether falls of this life were taken back, are, or will be by a command.
  bool mayRewind() const;
  /// Every row of the log and every weight, in 64 bits.
  std::uint64_t hash() const;

 private:
  /// Parameters that hold from an episode's beginning on.
  void takeParameters();
  /// Begins in this state; if it is empty, the environment draws one.
  void beginEpisode(const std::vector<double>& state = {});
  /// The agent's first action in the state where it begins, or begins anew.
  void startAgent();
  /// Takes back the fall that the agent has just learned; false: the environment does not do the same again.
  bool rewind();
  /// A test of the greedy policy, if one is due and has not been made.
  void test(const std::atomic<bool>* giveUp);
  /// Tells policy and agent the time: they may follow a schedule. `inTheMiddle`: one step since the last call, no more.
  void tellTime(bool inTheMiddle = false);
  void note(const std::string& key, const std::string& before, const std::string& after);
  /// A test of the greedy policy is due that did not happen, because its environment did not answer.
  bool owesTest() const;
  bool reachedAverage() const {
    return log_.averageReward() >= limits_.averageReward && log_.totals().episodes >= EpisodeLog::kAverageOver;
  }
  void obey(TimedCommand& command);
  /// The part that save() and resuming share.
  void transfer(Archive& archive);
  /// Whether the inputs of the episode in hand make sense.
  void checkEpisode(Archive& archive);
  /// Takes the environment to where it was, by giving it the same inputs again; false: it did not answer, or does not
  /// come to the same end.
  bool goBack();
  /// The episode's inputs again; false: they do not lead to where it was, which is the life's failure.
  bool repeatEpisode();

  std::unique_ptr<Environment> environment_;
  std::unique_ptr<Policy> policy_;
  std::unique_ptr<Agent> agent_;
  Parameters parameters_;
  std::string policyName_;
  bool preLearned_;
  std::vector<TimedCommand> commands_;
  std::size_t nextCommand_ = 0;
  Random worldRandom_, policyRandom_;
  LifeLimits limits_;
  EpisodeLog log_;
  std::vector<Change> changes_;
  bool changesLeftOut_ = false;
  std::int64_t steps_ = 0;
  Action action_ = 0;
  Outcome outcome_;  // of the last step
  bool inEpisode_ = false;
  bool environmentChanged_ = false;
  bool rewindingChanged_ = true;  // its parameters hold from the next episode on
  Rewinding rewinding_;           // in force in this episode
  std::string failure_;           // of the environment: it can not go on
  std::string unanswered_;        // its last answer did not come
  bool away_ = false;             // it has not been taken to where this saved life was
  Environment::CutOffs cutOffs_;  // when the life was saved
  GreedyTester tester_;
  std::optional<double> rule_;  // threshold by the rule of thumb, after the last episode
  bool everyStep_ = false;      // a schedule changes with every step

  // The environment's inputs since the beginning of the episode. With them a resumed life brings any environment to the
  // same state.
  bool keepInputs_ = false;
  std::unique_ptr<Guardians> guardians_;  // act for the policy where it asks for one
  bool explores_ = false;                 // the next action is not the best by q̂
  EpisodeInputs inputs_;                  // inputs of the current episode, or of the last one
};

}  // namespace surefoot
