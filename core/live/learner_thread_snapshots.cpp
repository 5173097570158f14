// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LearnerThread that fills the copies that others look at.
#include "core/live/learner_thread.h"

namespace surefoot {

void LearnerThread::answer() {
  if (snapshotWanted_.load(std::memory_order_relaxed)) {
    snapshotWanted_.store(false, std::memory_order_relaxed);
    fill(snapshots_.back());
    snapshots_.publish();
  }
  if (valuesWanted_.load(std::memory_order_relaxed)) {
    valuesWanted_.store(false, std::memory_order_relaxed);
    fill(values_.back());
    values_.publish();
  }
}

void MomentSeen::look(const Environment& environment, const ActionValueFunction& values) {
  state.assign(environment.state().begin(), environment.state().end());
  signals.resize(environment.signals().size());
  environment.readSignals(signals);
  measures.assign(environment.measures().begin(), environment.measures().end());
  evaluate(values, state);
}

StepSeen LearnerThread::stepToCome() const {
  StepSeen step;
  step.look(life_->environment(), life_->agent().values());
  step.action = life_->nextAction();
  step.steps = life_->steps();
  step.episode = life_->log().totals().episodes + 1;
  return step;
}

void LearnerThread::fill(Snapshot& s) {
  const Environment& environment = life_->environment();
  s.life = lifeNumber_;
  s.steps = life_->steps();
  s.simulatedSeconds = life_->simulatedSeconds();
  s.totals = life_->log().totals();
  s.averageReward = life_->log().averageReward();
  const ActionValueFunction& values = life_->agent().values();
  s.look(environment, values);
  s.pose = environment.pose();
  if (snapshots_.taken()) seen_.erase(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(seenPublished_));
  s.seen = seen_;  // with those of a snapshot that nobody has fetched
  seenPublished_ = seen_.size();
  s.fallenPose = fallenPose_;
  s.qPositive.resize(values.split() ? s.q.size() : 0);
  if (values.split()) values.evaluate(s.state, Layer::Positive, s.qPositive);
  s.learned = life_->agent().lastSteps();
  s.stateBefore = turbo_ ? std::vector<double>() : last_.state;
  s.actionBefore = last_.action;
  s.action = life_->inEpisode() ? life_->nextAction() : kNoAction;
  s.running = canStep();
  s.turbo = turbo_;
  s.pace = pace_;
  s.unanswered = life_->unanswered();
  s.flewApart = environment.cutOffs().all;
  s.unansweredTries = unansweredTries_;
  s.finished = life_->finished() && !life_->diverged() && s.unanswered.empty();
  s.trouble = life_->diverged() ? life_->divergence() : "";
  if (!trouble_.empty()) s.trouble = trouble_;
}

void LearnerThread::fillTests(ValueSnapshot& s) const {
  constexpr std::size_t kMost = 400;
  const auto& all = life_->greedyTests();
  const std::size_t stride = all.size() / kMost + 1;
  s.tests.clear();
  for (std::size_t i = 0; i < all.size(); i += stride) s.tests.push_back(all[i]);
  const Task& task = life_->environment().task();
  s.walksSince.reset();
  if (const GreedyTest* walk = firstWalk(all, task.measures); walk && task.stepTime)
    s.walksSince = static_cast<double>(walk->lifeSteps) * *task.stepTime / 60.0;
}

void LearnerThread::fill(ValueSnapshot& s) const {
  const ActionValueFunction& values = life_->agent().values();
  if (s.values && s.life == lifeNumber_)
    s.values->assign(values);
  else
    s.values = values.clone(), s.layouts = life_->agent().layouts();
  s.life = lifeNumber_;
  life_->agent().eligibility(s.eligibility);
  s.steps = life_->steps();
  s.simulatedSeconds = life_->simulatedSeconds();
  s.totals = life_->log().totals();
  s.fallsByHand = fallsByHand_;
  curve_.copyTo(s.curve);
  s.policy = curvePolicy_;
  s.changes = life_->changes();
  s.endOfLearning = life_->log().endOfLearning().episode();
  s.rule = ruleOfThumbOf(*life_);
  s.memory = values.memoryUse();
  const Calibration* calibration = life_->agent().calibration();
  s.calibration = calibration ? std::optional(calibration->report()) : std::nullopt;
  s.guarded = life_->agent().guarded();
  s.priceOfFall = life_->agent().priceOfFall();
  fillTests(s);
  s.endOfLearningSteps = life_->log().endOfLearning().lifeSteps();
}

}  // namespace surefoot
