// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/looking.h"

#include <algorithm>

#include "core/basics/expects.h"

namespace surefoot {

namespace {
constexpr int kFlash = static_cast<int>(1000 * kFallShown);  // [ms]
constexpr std::size_t kMostValuesKept = 16u << 20;           // [bytes] of values kept with falls
}  // namespace

Looking::Looking(RunningLife& life) : life_(life) {
  makeViewer();
  connect(&life_, &RunningLife::ticked, this, &Looking::advance);
  connect(&life_, &RunningLife::valuesArrived, this, &Looking::takeFalls);
  connect(&life_, &RunningLife::commanded, this, &Looking::backToLive);
  connect(&life_, &RunningLife::replaced, this, &Looking::beginAnew);
  connect(&life_, &RunningLife::policyChanged, this, [this] {
    const Configuration& c = life_.configuration();
    if (auto policy = makePolicy(life_.registry(), c.names.policy, c.parameters))
      viewer_->setPolicy(std::move(*policy));
  });
  connect(&life_, &RunningLife::parameterChanged, this, [this](const QString& key) {
    life_.configuration().parameters.applyTo(viewer_->policy(), "policy.");
    if (!key.startsWith(QLatin1String("environment."))) return;
    makeViewer();
    feed_.end();
  });
}

void Looking::makeViewer() {
  const Configuration& c = life_.configuration();
  auto environment = makeEnvironment(life_.registry(), c);
  auto policy = makePolicy(life_.registry(), c.names.policy, c.parameters);
  expects(environment && policy, "the configuration was checked before");
  viewer_ =
      std::make_unique<Viewer>(std::move(*environment), std::move(*policy), deriveSeed(c.seed, 0, Stream::Viewer));
}

/// Another life runs. Until its first snapshot comes, its environment is shown in its first state.
void Looking::beginAnew() {
  hovered_.clear();
  pinned_.clear();
  fallsToCome_.clear();
  recording_.clear();
  feed_.end();
  setSecond(nullptr, {});
  backToLive();
  makeViewer();
  shown_ = {};
  shown_.state.assign(viewer_->environment().state().begin(), viewer_->environment().state().end());
  shown_.pose = viewer_->pose();
  shown_.q.assign(life_.task().actions.size(), 0.0);
  Q_EMIT fallsArrived();
}

void Looking::advance(double seconds) {
  const Snapshot& now = life_.snapshot();
  if (std::exchange(lifeShown_, now.life) != now.life) fallsBefore_ = now.totals.falls;
  playback_ ? showPlayback(seconds) : show(seconds);
  Q_EMIT frame();
}

void Looking::show(double seconds) {
  if (!life_.isShown()) return;  // the snapshot is still from the life before, perhaps in another environment
  const Snapshot& now = life_.snapshot();
  const bool viewing = (life_.running() ? life_.turbo() : demonstrating_) && life_.values() && hasViewer();
  std::int64_t falls = now.totals.falls;
  if (viewing) {
    const ActionValueFunction& values = *life_.values()->values;
    writeSignals(true);
    viewer_->policy().advance(life_.lifeTime());
    viewer_->advance(seconds, values);
    shown_.state.assign(viewer_->environment().state().begin(), viewer_->environment().state().end());
    shown_.pose = viewer_->pose();
    shown_.q.resize(life_.task().actions.size());
    values.evaluate(shown_.state, Layer::Sum, shown_.q);  // the viewer's own values are from the step before
    fillParts(values);
    shown_.action = viewer_->action();
    falls = viewer_->falls();
  } else {
    shown_.state = now.state;
    shown_.pose = now.pose;
    shown_.q = now.q;
    shown_.qPositive = now.qPositive;
    shown_.qNegative = now.losses;
    shown_.risk = now.risk;
    shown_.action = now.action;
  }
  if (falls == fallsBefore_ + 1) sinceFall_.start();  // one fall; a larger jump means that another world is shown
  fallsBefore_ = falls;
  shown_.flash = sinceFall_.isValid() && sinceFall_.elapsed() < kFlash;
  // The next episode has begun already, but a person must see the fall: the fallen pose stays during the flash.
  if (shown_.flash && !viewing && !now.fallenPose.empty()) shown_.pose = now.fallenPose;
  if (!viewing) writeSignals(false);
  shown_.row = feed_.on() ? feed_.last() : -1;
  if (life_.running() || viewing || recording_.size() == 0) recording_.add(shown_);
}

void Looking::fillParts(const ActionValueFunction& values) {
  for (auto* part : {&shown_.qPositive, &shown_.qNegative}) part->resize(values.split() ? shown_.q.size() : 0);
  shown_.risk.resize(values.hasRisk() ? shown_.q.size() : 0);
  if (values.hasRisk()) values.evaluate(shown_.state, Layer::Risk, shown_.risk);
  if (!values.split()) return;
  values.evaluate(shown_.state, Layer::Positive, shown_.qPositive);
  values.evaluate(shown_.state, Layer::Negative, shown_.qNegative);
}

const ActionValueFunction* Looking::valuesShown() const {
  if (playback_ && playback_->values) return playback_->values.get();
  return life_.values() ? life_.values()->values.get() : nullptr;
}

void Looking::hold(std::optional<double> target) {
  viewer_->hold(target);
  life_.hold(target);
  Q_EMIT held(target);
}

void Looking::examine(const std::optional<std::vector<double>>& state) {
  const std::vector<double> next = state.value_or(std::vector<double>());
  if (next == hovered_) return;
  hovered_ = next;
  Q_EMIT examinedChanged();
}

void Looking::pin(const std::optional<std::vector<double>>& state) {
  pinned_ = state.value_or(std::vector<double>());
  Q_EMIT examinedChanged();
}

SeenFalls Looking::seen() const {
  std::size_t bytes = 0;
  for (const auto& [number, values] : seen_.values) bytes += values->bytes();
  return {seen_.falls, bytes <= kMostValuesKept ? seen_.values : decltype(seen_.values)()};
}

}  // namespace surefoot

#include "moc_looking.cpp"
