// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/running_life.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/basics/expects.h"
#include "core/schedule.h"
#include "core/text/text.h"
#include "ui/language/numbers.h"
#include "ui/running/beginning.h"

namespace surefoot {

namespace {
constexpr int kFrame = 16;  // [ms]
}  // namespace

Result<std::unique_ptr<Life>> makeLifeToRun(const Registry& registry, const Configuration& configuration,
                                            bool keepRows) {
  try {
    auto life = makeLife(registry, configuration, 0, keepRows);
    if (life) (*life)->keepInputs();  // so that it can be saved in the middle of an episode
    return life;
  } catch (const std::bad_alloc&) {
    return Error{QObject::tr("There is not enough memory for this; take fewer tiles or tilings.").toStdString()};
  }
}

RunningLife::RunningLife(const Registry& registry, Configuration configuration, bool keepRows)
    : registry_(registry),
      keepRows_(keepRows) {
  known_ = knownAs(registry, configuration, configuration);
  auto life = makeLifeToRun(registry_, configuration, keepRows);
  expects(static_cast<bool>(life), "the configuration was checked before");
  known_.bytes = (*life)->agent().values().bytes();
  curves_.setBegan(beginningOf(known_.began));
  learner_ = std::make_unique<LearnerThread>(std::move(*life));
  makeEnvironmentAnew();
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &RunningLife::tick);
  timer_.start(kFrame);
  clock_.start();
  sinceValues_.start();
}

RunningLife::~RunningLife() = default;

KnownLife knownAs(const Registry& registry, Configuration now, Configuration began) {
  KnownLife known;
  const auto plain = configure(registry, now.names, {});
  known.base = plain ? plain->parameters : now.parameters;
  known.configuration = std::move(now);
  known.began = std::move(began);
  return known;
}

void RunningLife::makeEnvironmentAnew() {
  auto environment = makeEnvironment(registry_, known_.configuration);
  expects(static_cast<bool>(environment), "the configuration was checked before");
  environment_ = std::move(*environment);
}

QString RunningLife::beginning() const {
  return QString::fromStdString(beginningOf(known_.began));
}

const ValueSnapshot* RunningLife::values() const {
  const ValueSnapshot& v = learner_->values();
  return v.values && v.life == lifeSent_ ? &v : nullptr;
}

CurvePoint RunningLife::latest() const {
  const auto& points = curves_.live().points;
  return points.empty() ? CurvePoint{} : points.back();
}

QString RunningLife::factorText() const {
  const double factor = numbers_.stepsPerSecond * task().stepTime.value_or(0.0);
  if (factor <= 0) return {};
  const double unit = factor >= 1000 ? 100 : factor >= 100 ? 10 : 1;
  return QStringLiteral("×") +
         localNumbers(factor < 9.95 ? fixedText(factor, 1) : countText(std::round(factor / unit) * unit));
}

std::optional<std::int64_t> RunningLife::changedAt(const std::string& key) const {
  const ValueSnapshot* v = values();
  if (!v) return std::nullopt;
  for (auto change = v->changes.rbegin(); change != v->changes.rend(); ++change)
    if (change->key == key) return change->step;
  return std::nullopt;
}

LifeTime RunningLife::lifeTime() const {
  const ValueSnapshot* v = values();
  const std::optional<double> rule = v && v->rule ? std::optional(v->rule->threshold) : std::nullopt;
  return {numbers_.episodes, numbers_.steps, rule};
}

double RunningLife::threshold() const {
  Scheduled threshold(0.0);
  Fields fields("policy.");
  threshold.declare(fields, {.key = "threshold", .title = "", .low = 0, .high = 0, .help = ""}, true);
  configuration().parameters.apply(fields);
  threshold.advance(lifeTime());
  return threshold.now();
}

LifeProgress RunningLife::progress() const {
  return isShown() ? LifeProgress{snapshot().totals.episodes, snapshot().steps} : known_.progress;
}

std::size_t RunningLife::bytes() const {
  const ValueSnapshot* newest = values();
  return std::max(known_.bytes, newest ? newest->values->bytes() : 0);
}

KnownLife RunningLife::known() const {
  KnownLife known = known_;
  known.progress = progress();
  known.falls = numbers_.falls;
  known.bytes = bytes();
  return known;
}

std::vector<Fall> RunningLife::takeFalls() {
  std::vector<Fall> falls = learner_->takeFalls();
  std::erase_if(falls, [this](const Fall& f) { return f.life != lifeSent_; });
  return falls;
}

std::unique_ptr<Life> RunningLife::finish() {
  timer_.stop();
  return learner_->stop();
}

}  // namespace surefoot

#include "moc_running_life.cpp"
