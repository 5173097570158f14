// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/inspection/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "physics/robot/inspection/parts.h"
#include "physics/robot/inspection/passive.h"
#include "physics/robot/inspection/warnings.h"
#include "physics/robot/spec/every_formula.h"

namespace surefoot {

namespace {

constexpr int kStartedAnewEvery = 700;

class Inspection {
 public:
  /// `child`: null for a robot that Box2D moves.
  Inspection(std::shared_ptr<const RobotSpec> spec, std::unique_ptr<ChildRobot> child)
      : spec_(std::move(spec)),
        box2d_(child ? nullptr : std::make_unique<Robot>(spec_)),
        child_(std::move(child)),
        robot_(child_ ? static_cast<Environment&>(*child_) : *box2d_),
        values_(child_ ? child_->values() : box2d_->values()) {}

  EnvironmentInspection all() {
    describe();
    live();
    if (spec_->joints.empty()) {
      found_.passive.seconds = 0;
    } else {
      found_.passive = energyOf(passiveRobot(*spec_, 1));
      found_.halved = energyOf(passiveRobot(*spec_, 2));
    }
    if (!found_.unanswered.empty()) return std::move(found_);
    propose();
    addWarnings(*spec_, robot_.task(), seen_, found_);
    return std::move(found_);
  }

 private:
  void describe() {
    found_.name = spec_->name, found_.title = spec_->title;
    found_.stepTime = *robot_.task().stepTime;
    found_.stepLimit = values_.stepLimit();
    found_.actions = actionsOf(robot_.task());
    for (const EndingSpec& ending : spec_->endings)
      found_.endings.push_back({ending.name, ending.text, ending.kind == EndingSpec::Kind::Fall, 0});
    found_.endings.push_back({"step limit", "", false, 0});
    if (box2d_)
      describeWorld();
    else
      robot_.draw(robot_.pose(), found_.drawing);
    describeStates();
  }
  void describeWorld() {
    const RobotNumbers& numbers = box2d_->numbers();
    found_.scale = numbers.scale;
    for (std::size_t j = 0; j < spec_->joints.size(); ++j)
      found_.joints.emplace_back(spec_->joints[j].name, numbers.joints[j].soft);
    for (const BodyNumbers& body : numbers.bodies)
      for (const ShapeNumbers& shape : body.shapes) {
        if (shape.meets == Meets::Nothing) continue;
        const bool round = shape.kind == ShapeSpec::Kind::Circle || shape.kind == ShapeSpec::Kind::Rod;
        const double radius = round ? shape.radius : 0.5 * std::min(shape.size.x, shape.size.y);
        if (radius > 0.0 && (found_.smallestRadius == 0.0 || radius < found_.smallestRadius))
          found_.smallestRadius = radius;
      }
    describeParts(*spec_, *box2d_, found_);
  }
  void describeStates() {
    for (std::size_t i = 0; i < robot_.task().state.size(); ++i) {
      const StateVariable& v = robot_.task().state[i];
      SeenState seen{.key = v.key, .title = v.title, .symbol = v.symbol, .unit = v.unit, .low = v.low, .high = v.high};
      seen.rangeAt = spec_->states[i].place;
      seen.width = v.span / v.resolution;
      seen.seenLow = kInfinity, seen.seenHigh = -kInfinity;
      seen.tiles = static_cast<int>(std::min(1e9, std::ceil((v.high - v.low) / v.span * v.resolution - 1e-9))) +
                   (v.period ? 0 : 1);
      found_.states.push_back(seen);
    }
  }

  void note(std::span<const double> state) {
    for (std::size_t s = 0; s < state.size(); ++s) {
      SeenState& seen = found_.states[s];
      seen.seenLow = std::min(seen.seenLow, state[s]);
      seen.seenHigh = std::max(seen.seenHigh, state[s]);
      seen.outside += state[s] < seen.low || state[s] > seen.high ? 1.0 / kInspectedSteps : 0.0;
      const double range = seen.high - seen.low, from = seen.low - 0.25 * range;
      const double bin = (state[s] - from) / (1.5 * range) * SeenState::kBins;
      if (bin >= 0 && bin < static_cast<double>(SeenState::kBins)) ++seen.bins[static_cast<std::size_t>(bin)];
    }
    seen_.states.emplace_back(state.begin(), state.end());
  }

  void live() {
    const auto trace = traceOf(*spec_);
    found_.traceTitle = trace.title;
    found_.steps = kInspectedSteps;
    Random random(1);
    const auto actions = static_cast<double>(robot_.task().actions.size());
    seen_.rewarded.assign(spec_->rewards.size(), false);
    std::vector<double> toFall;
    std::vector<int> atLimit(spec_->joints.size(), 0);
    if (!begin(random, 0)) return;
    evaluateFormulas();
    int begun = 0;
    for (int step = 1; step <= kInspectedSteps; ++step) {
      if (child_ && step % kStartedAnewEvery == 0) child_->stopProgram();  // in a new one, the episode is the same
      const Outcome outcome = robot_.step(static_cast<Action>(random.uniform() * actions));
      if (outcome.ending == Ending::Unanswered) return giveUp(step - 1);
      note(robot_.state());
      found_.trace.push_back(trace.body < 0 ? robot_.state()[static_cast<std::size_t>(trace.state)]
                                            : box2d_->world().placement(trace.body).at.y);
      if (box2d_) found_.jointGap = std::max(found_.jointGap, box2d_->world().jointSeparation());
      for (std::size_t j = 0; j < atLimit.size(); ++j) atLimit[j] += isAtLimit(j);
      for (std::size_t r = 0; r < seen_.rewarded.size(); ++r)
        seen_.rewarded[r] = seen_.rewarded[r] || outcome.terms[r] != 0.0;
      if (outcome.event == Event::Fall) found_.falls.push_back(step);
      if (outcome.ending == Ending::None) continue;
      const int which = values_.lastEnding() < 0 ? static_cast<int>(spec_->endings.size()) : values_.lastEnding();
      ++found_.endings[static_cast<std::size_t>(which)].count;
      if (outcome.event == Event::Fall) toFall.push_back((step - begun) * found_.stepTime);
      found_.longest = std::max(found_.longest, (step - begun) * found_.stepTime);
      seen_.atOnce += step - begun == 1;
      if (!begin(random, begun = step)) return;
    }
    seen_.episodes = static_cast<int>(found_.begins.size());
    found_.meanSteps = static_cast<double>(kInspectedSteps) / seen_.episodes;
    found_.flewApart = robot_.cutOffs().all;
    for (std::size_t j = 0; j < atLimit.size(); ++j)
      if (box2d_->numbers().joints[j].limits)
        found_.atLimits.emplace_back(spec_->joints[j].name, atLimit[j] / static_cast<double>(kInspectedSteps));
    std::sort(toFall.begin(), toFall.end());
    if (!toFall.empty()) found_.medianToFall = toFall[toFall.size() / 2];
    found_.verdict = verdict();
  }
  /// Those that are more than a number, and not drawn at random.
  void evaluateFormulas() {
    forEveryFormula(*spec_, [&](const Formula& formula) {
      const auto in = formula.expression.instructions();
      const auto drawn = [](const Instruction& i) { return i.operation == Operation::Uniform; };
      const bool plain = in.size() == 1 && in[0].operation == Operation::Constant;
      if (plain || formula.at.line == 0 || std::any_of(in.begin(), in.end(), drawn)) return;
      found_.formulas.push_back({formula.at, formula(values_.row())});
    });
  }
  bool begin(Random& random, int step) {
    robot_.reset(random);
    if (!robot_.unanswered().empty()) return giveUp(step), false;
    found_.begins.push_back(step);
    seen_.starts.insert({robot_.state().begin(), robot_.state().end()});
    return true;
  }
  /// The program that moves it does not answer after so many steps.
  void giveUp(int steps) {
    found_.steps = steps;
    found_.unanswered = robot_.unanswered();
    found_.verdict = "its program does not answer";
    for (SeenState& state : found_.states)
      if (state.seenLow > state.seenHigh) state.seenLow = state.seenHigh = 0.0;
  }
  bool isAtLimit(std::size_t j) {
    const auto& limits = box2d_->numbers().joints[j].limits;
    if (!limits) return false;
    const double near = 0.01 * (limits->second - limits->first);
    const double q = box2d_->world().jointPosition(static_cast<int>(j));
    return q <= limits->first + near || q >= limits->second - near;
  }
  std::string verdict() const {
    if (!robot_.task().canFall) return "no ending is a fall";
    if (found_.falls.empty()) return "never falls: nothing to avoid";
    if (found_.meanSteps < 5) return "falls at once: hardly anything to learn from";
    return "falls soon, but not at once: it can learn";
  }

  /// Outwards to two digits.
  static double rounded(double value, bool up) {
    if (value == 0.0) return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    return (up ? std::ceil(value / unit - 1e-9) : std::floor(value / unit + 1e-9)) * unit;
  }

  void propose() {
    found_.proposedScale =
        found_.smallestRadius > 0.0 ? std::clamp(std::round(0.2 / found_.smallestRadius), 1.0, 20.0) : found_.scale;
    found_.tiles = static_cast<double>(robot_.task().actions.size());
    for (SeenState& seen : found_.states) {
      found_.tiles *= seen.tiles;
      const double margin = 0.1 * (seen.seenHigh - seen.seenLow);
      seen.proposedLow = seen.outside > 0.05 ? rounded(std::min(seen.low, seen.seenLow - margin), false) : seen.low;
      seen.proposedHigh = seen.outside > 0.05 ? rounded(std::max(seen.high, seen.seenHigh + margin), true) : seen.high;
    }
  }

  std::shared_ptr<const RobotSpec> spec_;
  std::unique_ptr<Robot> box2d_;
  std::unique_ptr<ChildRobot> child_;
  Environment& robot_;
  const RobotValues& values_;
  EnvironmentInspection found_;
  RandomLifeSeen seen_;
};

}  // namespace

EnvironmentInspection inspectRobot(const std::shared_ptr<const RobotSpec>& spec, std::unique_ptr<ChildRobot> child) {
  return Inspection(spec, std::move(child)).all();
}

}  // namespace surefoot
