// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/life/life.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "core/life/inputs_text.h"
#include "core/life/rule_of_thumb.h"

namespace surefoot {

Life::Life(LifeParts parts, Random world, Random policy, LifeLimits limits, bool keepRows)
    : environment_(std::move(parts.environment)),
      policy_(std::move(parts.policy)),
      agent_(std::move(parts.agent)),
      parameters_(std::move(parts.parameters)),
      policyName_(std::move(parts.policyName)),
      preLearned_(parts.preLearned),
      commands_(std::move(parts.commands)),
      worldRandom_(world),
      policyRandom_(policy),
      limits_(limits),
      log_(keepRows, environment_->task().measures),
      tester_(std::move(parts.tests), parts.testSeed) {
  agent_->setPolicy(*policy_);
  setTeacher(std::move(parts.teacher));
  inputs_.random = worldRandom_.state();
  if (environment_->answersAtOnce()) beginEpisode();
}

void Life::setTeacher(std::unique_ptr<Agent> teacher) {
  auto guardians = std::make_unique<Guardians>(*environment_, std::move(teacher));
  agent_->setGuardian(guardians.get());
  guardians_ = std::move(guardians);
}

void Life::takeParameters() {
  if (environmentChanged_) {
    parameters_.applyTo(*environment_, "environment.");
    environment_->parametersChanged();
    tester_.follow(*environment_);
    environmentChanged_ = false;
  }
  if (rewindingChanged_) {
    parameters_.applyTo(rewinding_, "life.");
    keepInputs_ |= rewinding_.steps > 0;
    rewindingChanged_ = false;
  }
}

void Life::beginEpisode(const std::vector<double>& state) {
  takeParameters();
  inputs_.clear();
  inputs_.random = worldRandom_.state();
  environment_->reset(worldRandom_);
  unanswered_ = environment_->unanswered();
  inEpisode_ = unanswered_.empty();
  if (!inEpisode_) return;
  inputs_.start = state;
  if (!state.empty()) environment_->place(state);
  tellTime();
  startAgent();
}

void Life::startAgent() {
  const std::int64_t explored = agent_->explored();
  action_ = agent_->start(environment_->state(), policyRandom_);
  explores_ = agent_->explored() != explored;
}

void Life::begin() {
  if (away_ && !goBack()) return;
  if (!inEpisode_ && steps_ == 0) beginEpisode();
}

bool Life::owesTest() const {
  const std::int64_t episodes = log_.totals().episodes;
  if (inEpisode_ || action_ == kHandMade || episodes == 0 || !tester_.due(episodes)) return false;
  return tester_.tests().empty() || tester_.tests().back().episode != episodes;
}

void Life::test(const std::atomic<bool>* giveUp) {
  if (owesTest()) unanswered_ = tester_.test(agent_->values(), *policy_, log_.totals().episodes, steps_, giveUp);
}

void Life::tellTime(bool inTheMiddle) {
  if (!inTheMiddle) {
    const auto rule = ruleOfThumbOf(*this);
    rule_ = rule ? std::optional(rule->threshold) : std::nullopt;
  }
  const LifeTime time{log_.totals().episodes, steps_, rule_};
  policy_->advance(time);
  agent_->advance(time);
  everyStep_ = policy_->everyStep() || agent_->everyStep();
}

void Life::step(const std::atomic<bool>* giveUp) {
  while (nextCommand_ < commands_.size() && commands_[nextCommand_].step <= steps_) obey(commands_[nextCommand_++]);
  unanswered_.clear();
  if (away_ && !goBack()) return;
  if (!inEpisode_) {
    test(giveUp);                          // one that is owed
    if (finished() || owesTest()) return;  // no answer again, or the life was at its end
    beginEpisode();
    if (!unanswered_.empty()) return;
  }
  if (everyStep_) tellTime(true);
  const std::int64_t explored = keepInputs_ ? agent_->explored() : 0;
  const Outcome outcome = outcome_ = environment_->step(action_);
  if (outcome.ending == Ending::Unanswered) {
    unanswered_ = environment_->unanswered();
    return;
  }
  if (keepInputs_) {
    inputs_.actions.push_back(static_cast<std::uint16_t>(action_));
    inputs_.explored.push_back(explores_);
  }
  ++steps_;
  log_.add(outcome);
  switch (outcome.ending) {
    case Ending::Unanswered:
      return;  // as above
    case Ending::None:
      action_ = agent_->step(outcome, environment_->state(), policyRandom_);
      explores_ = keepInputs_ && agent_->explored() != explored;
      return;
    case Ending::Terminal:
      agent_->end(outcome);
      if (outcome.event == Event::Fall && rewinding_.takesBack(log_.current().rewinds) && rewind()) return;
      break;
    case Ending::Truncated:
      agent_->truncate(outcome, environment_->state(), policyRandom_);
      failure_ = environment_->failure();
      break;
  }
  log_.finish(outcome.ending, steps_, environment_->task().highestReturn, environment_->measures());
  inEpisode_ = false;
  test(giveUp);
}

Status Life::set(std::string_view key, double value) {
  const Parameters::Entry* entry = parameters_.find(key);
  const double before = entry ? entry->value : 0.0;
  if (entry && entry->parameter.when == When::NewTable)
    return Error{fmt::format("{}: a new table is needed for it, so it holds from the next life on.", key)};
  if (const Status s = parameters_.set(key, value); !s) return s;
  if (value == before) return Done{};
  if (const Status s = checkRewinding(parameters_, *environment_); !s) {
    static_cast<void>(static_cast<bool>(parameters_.set(key, before)));
    return s;
  }

  // The task may depend on any parameter of the environment; the environment makes it anew at the next episode.
  if (key.starts_with("environment.")) environmentChanged_ = true;
  if (key.starts_with("life.")) rewindingChanged_ = true;
  if (entry->parameter.when == When::Now) {
    const auto applyTo = [&](Configurable& part, const char* prefix) {
      Fields fields(prefix);
      part.declare(fields);
      for (const auto& field : fields.all())
        if (field.parameter.key == key) field.set(value);
    };
    applyTo(*environment_, "environment.");
    if (environmentChanged_) tester_.follow(*environment_);
    applyTo(*policy_, "policy.");
    if (const Status s = policy_->caution().check(
            usableBy(agent_->values(), environment_->task().handMade, guardians_->hasTeacher()));
        !s) {
      static_cast<void>(static_cast<bool>(parameters_.set(key, before)));
      parameters_.applyTo(*policy_, "policy.");
      return s;
    }
    applyTo(*agent_, "agent.");
    tellTime();
  }
  note(entry->parameter.key, formatValue(entry->parameter, before), formatValue(entry->parameter, value));
  return Done{};
}

void Life::obey(TimedCommand& command) {
  if (command.key == "policy")
    setPolicy(command.policyName, std::move(command.policy));
  else if (command.key == "push")
    push(command.value);
  else if (command.key == "place")
    static_cast<void>(static_cast<bool>(place(command.state)));  // as below
  else if (command.key == "go_on")
    static_cast<void>(static_cast<bool>(goOn(command.until)));  // as it went then
  else
    static_cast<void>(static_cast<bool>(set(command.key, command.value)));  // checked when the life was made
}

bool Life::push(double impulse) {
  if (!inEpisode_) return true;  // between two episodes there is no body to push
  if (!environment_->push(impulse)) return false;
  if (keepInputs_) {
    inputs_.pushSteps.push_back(static_cast<std::uint64_t>(inputs_.actions.size()));
    inputs_.pushImpulses.push_back(impulse);
  }
  note("push", "", fmt::format("{}", impulse));
  return true;
}

Status Life::place(const std::vector<double>& state) {
  if (const Status s = checkState(environment_->task(), state); !s) return s;
  if (!environment_->place(state)) return Error{"place: this environment begins only where it always does."};
  if (inEpisode_) {
    agent_->abandon();
    log_.giveUp();
  }
  beginEpisode(state);
  note("place", "", fmt::format("{}", fmt::join(state, " ")));
  return Done{};
}

Status Life::goOn(const EpisodeInputs& until) {
  if (!environment_->answersAtOnce())
    return Error{"go_on: a robot that a program moves cannot be put back into a moment."};
  if (inEpisode_) {
    agent_->abandon();
    log_.giveUp();
  }
  note("go_on", "", textOf(until));
  takeParameters();
  Random random(0);
  Ending ending = Ending::None;
  if (!repeat(until, *environment_, random, ending, [](const Outcome&, Action) {}) || ending != Ending::None) {
    beginEpisode();
    return Error{"go_on: under the model of now the episode ends before that moment; a new one begins."};
  }
  worldRandom_ = random;
  inputs_ = until;
  inputs_.before = until.actions.size();
  inEpisode_ = true;
  tellTime();
  startAgent();
  return Done{};
}

void Life::note(const std::string& key, const std::string& before, const std::string& after) {
  if (!changes_.empty() && changes_.back().key == key && changes_.back().step == steps_ && key != "push")
    changes_.back().after = after;
  else if (changes_.size() < kMostChanges)
    changes_.push_back({steps_, key, before, after});
  else
    changesLeftOut_ = true;
}

void Life::setPolicy(const std::string& name, std::unique_ptr<Policy> policy) {
  if (name != policyName_) note("policy", policyName_, name);
  policyName_ = name;
  parameters_.applyTo(*policy, "policy.");
  policy_ = std::move(policy);
  agent_->setPolicy(*policy_);
  tellTime();
}

std::string Life::divergence() const {
  if (!failure_.empty()) return failure_;
  // The largest step size is the likeliest cause; accumulating traces make any of them larger.
  const Parameters::Entry* largest = nullptr;
  const bool shaped = parameters_.find("shaping.rewards") && parameters_.get("shaping.rewards") != 0.0;
  for (const auto& entry : parameters_.all()) {
    const std::string& key = entry.parameter.key;
    if (!key.ends_with(".step_size") || (key.starts_with("shaping.") && !shaped)) continue;
    if (!largest || entry.value > largest->value) largest = &entry;
  }
  std::string cause = "try smaller rewards";
  if (largest)
    cause = fmt::format("{} = {} is the likely cause; try a smaller one", largest->parameter.key, largest->value);
  const Parameters::Entry* trace = parameters_.find("agent.trace");
  if (largest && trace && trace->value != 0.0)
    cause = fmt::format("agent.trace = accumulating with {} = {} is the likely cause; try replacing traces",
                        largest->parameter.key, largest->value);
  return fmt::format("The action values diverged at step {}, in episode {}: {}.", steps_, log_.totals().episodes + 1,
                     cause);
}

double Life::simulatedSeconds() const {
  const auto& stepTime = environment_->task().stepTime;
  return stepTime ? static_cast<double>(steps_) * *stepTime : std::numeric_limits<double>::quiet_NaN();
}

std::uint64_t Life::hash() const {
  Hash64 hash = log_.hash();
  for (const auto& table : agent_->values().tables())
    for (const double w : table) hash.add(w);
  return hash.value();
}

}  // namespace surefoot
