// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Life that saves and resumes it, and takes falls back. The environment is not saved but brought to the
// same state again: a reset with the same random numbers, then the same actions and pushes.
#include <algorithm>

#include "core/life/life.h"
#include "core/life/rule_of_thumb.h"

namespace surefoot {

namespace {
constexpr std::size_t kMostInputs = 1'000'000'000;
}

Life::Life(LifeParts parts, LifeLimits limits, bool keepRows, Archive& archive)
    : environment_(std::move(parts.environment)),
      policy_(std::move(parts.policy)),
      agent_(std::move(parts.agent)),
      parameters_(std::move(parts.parameters)),
      policyName_(std::move(parts.policyName)),
      preLearned_(parts.preLearned),
      commands_(std::move(parts.commands)),
      worldRandom_(0),
      policyRandom_(0),
      limits_(limits),
      log_(keepRows, environment_->task().measures),
      changes_(std::move(parts.changes)),
      tester_(std::move(parts.tests), parts.testSeed),
      keepInputs_(true) {
  agent_->setPolicy(*policy_);
  setTeacher(std::move(parts.teacher));
  tester_.follow(*environment_);
  transfer(archive);
  if (archive.good()) checkEpisode(archive);
  away_ = archive.good() && !environment_->answersAtOnce();
  if (archive.good() && !away_ && !goBack() && !failure_.empty())
    archive.refuse("episode.actions", "does not lead to where the episode was");
  while (nextCommand_ < commands_.size() && commands_[nextCommand_].step < steps_) ++nextCommand_;
  if (const auto rule = ruleOfThumbOf(*this)) rule_ = rule->threshold;
  tellTime();
}

namespace {

/// Whether the environment has this action.
bool isAction(const Task& task, Action a) {
  return (a >= 0 && a < static_cast<Action>(task.actions.size())) || (task.handMade && a == kHandMade);
}

}  // namespace

void Life::save(Archive& archive) const {
  const_cast<Life*>(this)->transfer(archive);  // a writer changes nothing
}

void Life::transfer(Archive& archive) {
  std::array<std::uint64_t, 4> policyRandom = policyRandom_.state();
  archive.table("random.world", inputs_.random);
  archive.table("random.policy", policyRandom);
  policyRandom_ = Random(policyRandom);
  archive.value("steps", steps_, 0, kMostLifeSteps);
  const Task& task = environment_->task();
  archive.value("action", action_, kHandMade, static_cast<int>(task.actions.size()) - 1);
  if (archive.reading() && archive.good() && !isAction(task, action_)) archive.refuse("action", "is out of range");
  archive.value("pre_learned", preLearned_, 0, 1);
  archive.value("in_episode", inEpisode_, 0, 1);
  archive.value("environment_changed", environmentChanged_, 0, 1);
  archive.list("episode.actions", inputs_.actions, kMostInputs);
  archive.list("episode.start", inputs_.start, task.state.size());
  archive.list("episode.push_steps", inputs_.pushSteps, kMostInputs);
  archive.list("episode.push_impulses", inputs_.pushImpulses, kMostInputs);
  if (archive.reading() ? archive.has("episode.before") : inputs_.before > 0)
    archive.value("episode.before", inputs_.before, 0, kMostInputs);
  if (!archive.reading()) cutOffs_ = environment_->cutOffs();
  if (archive.reading() ? archive.has("cut_off.all") : cutOffs_.all > 0) {  // most lives have none
    archive.value("cut_off.all", cutOffs_.all, 0, kMostLifeSteps);
    archive.value("cut_off.in_a_row", cutOffs_.inARow, 0, kMostLifeSteps);
  }
  if (archive.reading() ? archive.has("rewinding.steps") : rewinding_.steps > 0) {
    archive.value("rewinding.steps", rewinding_.steps, 0, Rewinding::kMost);
    archive.value("rewinding.most", rewinding_.most, 0, Rewinding::kMost);
  }
  archive.under("log.", [&] { log_.transfer(archive); });
  tester_.transfer(archive);
  if (!archive.reading()) agent_->transferValues(archive);  // when reading, the agent was made from them
  archive.under("learning.", [&] { agent_->transferLearning(archive); });
}

void Life::checkEpisode(Archive& archive) {
  const auto& [random, start, actions, explored, pushSteps, pushImpulses, before] = inputs_;
  static_cast<void>(explored);  // only for people
  const Task& task = environment_->task();
  for (std::size_t i = 0; i < actions.size(); ++i)
    if (!isAction(task, inputs_.actionAt(i)))
      return archive.refuse("episode.actions", "names actions that there are not");
  if (pushSteps.size() != pushImpulses.size())
    return archive.refuse("episode.push_steps", "is not as long as the list of impulses");
  if (!std::is_sorted(pushSteps.begin(), pushSteps.end()) || (!pushSteps.empty() && pushSteps.back() > actions.size()))
    return archive.refuse("episode.push_steps", "is not in order, or goes beyond the episode");
  if (!start.empty() && !checkState(task, start))
    return archive.refuse("episode.start", "is no state of the environment");
  const auto steps = static_cast<std::int64_t>(actions.size());
  const EpisodeRow& row = log_.current();
  const std::int64_t most = row.steps + static_cast<std::int64_t>(before);
  if (inEpisode_ && (steps > most || (steps < most && row.rewinds == 0)))
    return archive.refuse("episode.actions", "is not as long as the episode");
}

bool Life::goBack() {
  unanswered_.clear();
  away_ = false;
  worldRandom_ = Random(inputs_.random);
  environment_->setCutOffs(cutOffs_);
  if (!inEpisode_ && inputs_.actions.empty()) return true;  // an episode was to begin
  return repeatEpisode();
}

bool Life::repeatEpisode() {
  const Environment::CutOffs cutOffs = environment_->cutOffs();
  Ending ending = Ending::None;
  const bool whole = repeat(inputs_, *environment_, worldRandom_, ending, [](const Outcome&, Action) {});
  if (ending == Ending::Unanswered) unanswered_ = environment_->unanswered();
  environment_->setCutOffs(cutOffs);  // an episode that was cut off has been so once more
  away_ = !unanswered_.empty();
  if (away_) return false;
  if (whole && (ending == Ending::None) == inEpisode_) return true;
  failure_ = "The environment does not do the same again: the episode in hand does not lead to where it was.";
  return false;
}

bool Life::rewind() {
  const auto back = static_cast<std::size_t>(rewinding_.steps);
  inputs_.keepFirst(inputs_.actions.size() - std::min(back, inputs_.actions.size()));
  if (!repeatEpisode()) return false;
  log_.takeFallBack();
  startAgent();
  return true;
}

bool Life::mayRewind() const {
  const Parameters::Entry* rewind = parameters_.find("life.rewind");
  if ((rewind && rewind->value > 0.0) || rewinding_.steps > 0 || log_.totals().rewinds > 0) return true;
  return std::any_of(commands_.begin(), commands_.end(),
                     [](const TimedCommand& c) { return c.key == "life.rewind" && c.value > 0.0; });
}

std::vector<std::pair<std::string, double>> Life::environmentInForce() const {
  Fields fields("environment.");
  const_cast<Environment&>(*environment_).declare(fields);  // reads only
  std::vector<std::pair<std::string, double>> values;
  for (const auto& field : fields.all()) values.emplace_back(field.parameter.key, field.get());
  return values;
}

}  // namespace surefoot
