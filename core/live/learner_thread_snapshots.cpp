// SPDX-License-Identifier: GPL-3.0-or-later
// The part of LearnerThread that fills the copies that others look at.
#include <utility>

#include "core/live/learner_thread.h"
#include "core/values_of_state.h"

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

StepSeen LearnerThread::momentNow() const {
  const Environment& environment = life_->environment();
  const ActionValueFunction& values = life_->agent().values();
  StepSeen moment{
      .steps = life_->steps(), .episode = life_->log().totals().episodes + 1, .action = life_->nextAction()};
  moment.state.assign(environment.state().begin(), environment.state().end());
  moment.signals.resize(environment.signals().size());
  environment.readSignals(moment.signals);
  moment.measures.assign(environment.measures().begin(), environment.measures().end());
  ValuesOfState here;
  here.evaluate(values, moment.state);
  moment.q = std::move(here.q), moment.risk = std::move(here.risk), moment.losses = std::move(here.losses);
  return moment;
}

void LearnerThread::fill(Snapshot& s) {
  const Environment& environment = life_->environment();
  s.life = lifeNumber_;
  s.steps = life_->steps();
  s.simulatedSeconds = life_->simulatedSeconds();
  s.totals = life_->log().totals();
  s.averageReward = life_->log().averageReward();
  s.state.assign(environment.state().begin(), environment.state().end());
  s.pose = environment.pose();
  s.signals.resize(environment.signals().size());
  environment.readSignals(s.signals);
  s.measures.assign(environment.measures().begin(), environment.measures().end());
  s.seen = std::exchange(seen_, {});
  s.fallenPose = fallenPose_;
  const ActionValueFunction& values = life_->agent().values();
  s.q.resize(environment.task().actions.size());
  values.evaluate(s.state, Layer::Sum, s.q);
  const bool split = values.split();
  for (auto* part : {&s.qPositive, &s.qNegative}) part->resize(split ? s.q.size() : 0);
  s.risk.resize(values.hasRisk() ? s.q.size() : 0);
  if (values.hasRisk()) values.evaluate(s.state, Layer::Risk, s.risk);
  if (split) {
    values.evaluate(s.state, Layer::Positive, s.qPositive);
    values.evaluate(s.state, Layer::Negative, s.qNegative);
  }
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
