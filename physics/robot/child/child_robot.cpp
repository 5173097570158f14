// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/child_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/basics/hash64.h"
#include "physics/robot/child/cage.h"
#include "physics/robot/child/program_files.h"

namespace surefoot {

ChildRobot::ChildRobot(std::shared_ptr<const RobotSpec> spec, std::string program, std::string folder,
                       std::shared_ptr<const EnvironmentPrograms> programs)
    : values_(std::move(spec)),
      program_(std::move(program)),
      programs_(std::move(programs)),
      link_(values_.spec(), std::move(folder), [this] { return programs_->isStopped(); }),
      numbers_(values_.spec().child.sends.size(), 0.0) {
  ChildRobot::parametersChanged();
}

void ChildRobot::parametersChanged() {
  values_.computeConstants();
  values_.renewTask();
  std::fill(numbers_.begin(), numbers_.end(), 0.0);
  values_.startEpisode();
  read();
  static_cast<void>(values_.settle());  // a program has said nothing yet
}

Status ChildRobot::check() const {
  RobotValues copy = values_;
  copy.computeConstants();
  constexpr double kShortest = 1e-5, kLongest = 10;  // [s]
  const double stepTime = values_.spec().stepTime(copy.row());
  if (stepTime >= kShortest && stepTime <= kLongest) return Done{};
  return Error{
      fmt::format("{}: step_time = {}; allowed is {} … {} s.", values_.spec().name, stepTime, kShortest, kLongest)};
}

void ChildRobot::read() {
  const RobotNames& names = values_.spec().names;
  const auto row = values_.row().subspan(static_cast<std::size_t>(names.firstProbe()));
  for (std::size_t i = 0; i < names.probes().size(); ++i) {
    const Probe& probe = names.probes()[i];
    const auto index = static_cast<std::size_t>(probe.index);
    row[i] = probe.of == NameKind::Child ? numbers_[index] : values_.levels()[index];
  }
}

std::uint64_t ChildRobot::printOf(std::span<const double> numbers) const {
  Hash64 hash;
  for (const double number : numbers) hash.add(number);
  return hash.value();
}

Status ChildRobot::start() {
  if (!programs_->isAllowed(program_))
    return Error{
        fmt::format("The robot {} starts a program, {}, in {}, {}. Nobody has allowed it yet (on the page Robot, "
                    "with --allow-programs, or from C and Python with \"programs\": true).",
                    values_.spec().name, commandText(values_.spec()), link_.folder(), cageText())};
  if (programOf(values_.spec(), link_.folder()) != program_)
    return Error{
        fmt::format("The program of the robot {}, {}, is no longer the one that was read: a file in {} has changed. "
                    "Open the robot anew.",
                    values_.spec().name, commandText(values_.spec()), link_.folder())};
  if (const auto cage = hasCage(); cage && !*cage)
    programs_->remark(
        fmt::format("The robot {} starts {} {}.", values_.spec().name, commandText(values_.spec()), cageText()));
  return link_.start(*values_.task().stepTime, programs_->modules());
}

Status ChildRobot::goBack() {
  std::vector<double> numbers(numbers_.size());
  if (const Status s = start(); !s) return s;
  if (const Status s = link_.reset(random_, parameters_, numbers); !s) return s;
  const std::size_t actuators = values_.levels().size();
  for (std::size_t step = 0;; ++step) {
    if (printOf(numbers) != prints_[step]) {
      link_.stop();
      return Error{
          fmt::format("The program of the robot {} does not do the same again: in the same episode it answers "
                      "step {} with other numbers. All chance must come from the random words of a reset.",
                      values_.spec().name, step)};
    }
    if (step * actuators == levels_.size()) return Done{};
    if (const Status s = link_.step(std::span(levels_).subspan(step * actuators, actuators), numbers); !s) return s;
  }
}

void ChildRobot::reset(Random& random) {
  Random drawn = random;
  for (std::uint64_t& word : random_) word = drawn.next();
  parameters_.assign(values_.parameters().begin(), values_.parameters().end());
  levels_.clear(), prints_.clear();
  Status answer = link_.isRunning() ? Status(Done{}) : start();
  if (answer) answer = link_.reset(random_, parameters_, numbers_);
  why_ = answer ? "" : answer.error().message;
  if (!answer) return;
  random = drawn;
  prints_.push_back(printOf(numbers_));
  values_.startEpisode();
  read();
  nowhere_ = !values_.settle();
}

Outcome ChildRobot::step(Action action) {
  Status answer = prints_.empty()     ? Status(Error{"No episode of the robot has begun."})
                  : link_.isRunning() ? Status(Done{})
                                      : goBack();
  values_.decide(action);
  if (answer) answer = link_.step(values_.levels(), numbers_);
  why_ = answer ? "" : answer.error().message;
  if (!answer) return {.ending = Ending::Unanswered};
  levels_.insert(levels_.end(), values_.levels().begin(), values_.levels().end());
  prints_.push_back(printOf(numbers_));
  values_.tick();
  read();
  Outcome outcome;
  if (nowhere_ || !values_.judge(outcome)) return mishaps_.cutOff(values_);
  if (outcome.ending != Ending::None) mishaps_.wentWell();
  return outcome;
}

}  // namespace surefoot
