// SPDX-License-Identifier: GPL-3.0-or-later
// The talk with a program that moves a robot (frames.h): started when it is needed, and bounded in time. An error is a
// sentence, and leaves no program behind: the next reset() starts a new one. One thread; the thread may change.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/basics/result.h"
#include "physics/robot/child/frames.h"
#include "physics/robot/child/process.h"
#include "physics/robot/spec/robot_spec.h"

namespace surefoot {

/// The content of the first frame: "name car", "step_time 0.05", "sends x v", "levels push", "parameters power".
std::string helloText(const RobotSpec& spec, double stepTime);

class ChildLink {
 public:
  /// `folder`: where the command is run; `stopped`: nobody waits for answers any more.
  ChildLink(const RobotSpec& spec, std::string folder, std::function<bool()> stopped)
      : spec_(spec),
        folder_(std::move(folder)),
        stopped_(std::move(stopped)) {}

  const std::string& folder() const { return folder_; }
  bool isRunning() const { return process_ != nullptr; }
  int id() const { return process_ ? process_->id() : 0; }
  /// `modules`: of Python.
  Status start(double stepTime, const std::string& modules);
  /// The numbers that the program sends at the beginning of an episode; the three of its own are 0.
  Status reset(const std::array<std::uint64_t, 4>& random, std::span<const double> parameters,
               std::span<double> numbers);
  Status step(std::span<const double> levels, std::span<double> numbers);
  void stop() { process_.reset(); }

 private:
  Status send(FrameKind kind, std::span<const std::byte> content);
  Status receive(FrameKind kind, std::span<std::byte> content, std::chrono::milliseconds patience);
  Status check(std::span<const double> numbers);
  Error ended(const std::string& why);

  const RobotSpec& spec_;
  std::string folder_;
  std::function<bool()> stopped_;
  std::unique_ptr<Process> process_;
  std::vector<std::byte> out_;
};

}  // namespace surefoot
