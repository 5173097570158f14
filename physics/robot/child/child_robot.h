// SPDX-License-Identifier: GPL-3.0-or-later
// A robot that a program moves, as an environment. The program starts with the first reset, when it is allowed. If it
// ends, falls silent or sends what is no answer, the step did not happen (Ending::Unanswered); the next try starts the
// program anew, takes it through the episode up to here by the same random words and levels, and tells if it does not
// do the same again.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/environment.h"
#include "core/environment_programs.h"
#include "physics/robot/child/child_link.h"
#include "physics/robot/task/mishaps.h"
#include "physics/robot/task/robot_values.h"

namespace surefoot {

class ChildRobot final : public Environment {
 public:
  /// `program`: under which it is allowed to start, in `folder`.
  ChildRobot(std::shared_ptr<const RobotSpec> spec, std::string program, std::string folder,
             std::shared_ptr<const EnvironmentPrograms> programs);

  void declare(Fields& f) override { values_.declare(f); }
  const Task& task() const override { return values_.task(); }
  void reset(Random& random) override;
  Outcome step(Action action) override;
  Action handMadeAction() const override { return values_.handMadeAction(); }
  bool answersAtOnce() const override { return false; }
  std::string unanswered() const override { return why_; }
  CutOffs cutOffs() const override { return mishaps_.counts(); }
  void setCutOffs(const CutOffs& before) override { mishaps_.setCounts(before); }
  std::string failure() const override { return mishaps_.failure(values_.spec(), values_.parameters()); }
  std::span<const double> state() const override { return values_.state(); }
  std::span<const double> measures() const override { return values_.measures(); }
  /// The numbers that the program sends.
  std::vector<Signal> signals() const override;
  void readSignals(std::span<double> values) const override;
  /// The row of numbers.
  std::vector<double> pose() const override { return {values_.row().begin(), values_.row().end()}; }
  void draw(std::span<const double> pose, Scene& scene) const override;
  std::vector<ReadOut> readOuts(std::span<const double> pose) const override;
  Status check() const override;
  void parametersChanged() override;

  const RobotValues& values() const { return values_; }
  /// The next step starts it anew.
  void stopProgram() { link_.stop(); }
  /// Of the program; 0: it does not run.
  int programId() const { return link_.id(); }

 private:
  void read();
  Status start();
  Status goBack();
  std::uint64_t printOf(std::span<const double> numbers) const;

  RobotValues values_;
  Mishaps mishaps_;
  bool nowhere_ = false;  ///< the start of this episode had no numbers: its first step cuts it off
  std::string program_;
  std::shared_ptr<const EnvironmentPrograms> programs_;
  ChildLink link_;
  std::vector<double> numbers_;  ///< that the program sent last
  std::string why_;

  // The inputs of this episode, and a print of each answer.
  std::array<std::uint64_t, 4> random_{};
  std::vector<double> parameters_, levels_;
  std::vector<std::uint64_t> prints_;
};

}  // namespace surefoot
