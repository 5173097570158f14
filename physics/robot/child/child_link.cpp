// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/robot/child/child_link.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "core/text/printable.h"
#include "core/text/text.h"
#include "physics/robot/child/cage.h"

namespace surefoot {

namespace {

static_assert(std::endian::native == std::endian::little);  // frames are

constexpr std::chrono::seconds kHelloPatience(60), kAnswerPatience(5);  // Python takes its time to import things

constexpr const char* kStopped = "it was left, for all is to end";

std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span(text));
}

}  // namespace

std::string helloText(const RobotSpec& spec, double stepTime) {
  std::vector<std::string> levels;
  for (const ActuatorSpec& actuator : spec.actuators) levels.push_back(actuator.name);
  std::vector<std::string> parameters;
  for (const Parameter& parameter : spec.parameters) parameters.push_back(parameter.key);
  const std::span<const std::string> sends = std::span(spec.child.sends).subspan(ChildSpec::kOwn);
  return fmt::format("{}\nname {}\nstep_time {}\nsends {}\nlevels {}\nparameters {}\n", kChildFormat, spec.name,
                     stepTime, fmt::join(sends, " "), fmt::join(levels, " "), fmt::join(parameters, " "));
}

Error ChildLink::ended(const std::string& why) {
  stop();
  return Error{fmt::format("The program of the robot {} ({}): {}.", spec_.name,
                           printable(shortened(fmt::format("{}", fmt::join(spec_.child.command, " ")))), why)};
}

Status ChildLink::send(FrameKind kind, std::span<const std::byte> content) {
  if (stopped_()) return ended(kStopped);
  if (process_->saysMore()) return ended("it says more than it is asked (does it print to its standard output?)");
  const FrameHead head{static_cast<std::uint32_t>(kind), static_cast<std::uint32_t>(content.size())};
  out_.resize(sizeof head + content.size());
  std::memcpy(out_.data(), &head, sizeof head);
  if (!content.empty()) std::memcpy(out_.data() + sizeof head, content.data(), content.size());
  if (process_->write(out_)) return Done{};
  return ended(process_->end());
}

Status ChildLink::receive(FrameKind kind, std::span<std::byte> content, std::chrono::milliseconds patience) {
  FrameHead head;
  const auto until = Process::Clock::now() + patience;
  const auto fill = [&](std::span<std::byte> bytes) -> Status {
    switch (process_->read(bytes, until, stopped_)) {
      case Process::Reading::Done:
        return Done{};
      case Process::Reading::Ended:
        return ended(process_->end());
      case Process::Reading::Stopped:
        return ended(kStopped);
      case Process::Reading::TimedOut:
        break;
    }
    return ended(fmt::format("it did not answer within {} s",
                             std::chrono::duration_cast<std::chrono::seconds>(patience).count()));
  };
  if (const Status s = fill(std::as_writable_bytes(std::span(&head, 1))); !s) return s;
  if (head.kind == static_cast<std::uint32_t>(FrameKind::Trouble) && head.bytes <= kLongestTrouble) {
    std::string sentence(head.bytes, ' ');
    if (const Status s = fill(std::as_writable_bytes(std::span(sentence))); !s) return s;
    return ended("it says: " + printable(shortened(sentence)));
  }
  if (head.kind == static_cast<std::uint32_t>(kind) && head.bytes == content.size()) return fill(content);
  return ended(
      fmt::format("its answer is no frame of ours: kind {} with {} bytes, where kind {} with {} is expected "
                  "(does it print to its standard output?)",
                  head.kind, head.bytes, static_cast<std::uint32_t>(kind), content.size()));
}

Status ChildLink::start(double stepTime, const std::string& modules) {
  const auto words = caged(spec_.child.command, folder_, modules);
  auto made = words ? Process::start(*words, childEnvironment(modules)) : words.error();
  if (!made) return Error{fmt::format("The program of the robot {}: {}.", spec_.name, made.error().message)};
  process_ = std::move(*made);
  if (const Status s = send(FrameKind::Hello, bytesOf(helloText(spec_, stepTime))); !s) return s;
  std::string format(std::strlen(kChildFormat), ' ');
  if (const Status s = receive(FrameKind::Hello, std::as_writable_bytes(std::span(format)), kHelloPatience); !s)
    return s;
  if (format == kChildFormat) return Done{};
  return ended(fmt::format("it speaks \"{}\", not \"{}\"", printable(format), kChildFormat));
}

Status ChildLink::check(std::span<const double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool flag = i == ChildSpec::kTerminated || i == ChildSpec::kTruncated;
    if (!std::isfinite(numbers[i]) || (flag && numbers[i] != 0.0 && numbers[i] != 1.0))
      return ended(fmt::format("it sent {} = {}; it must be {}", spec_.child.sends[i], numbers[i],
                               flag ? "0 or 1" : "a finite number"));
  }
  return Done{};
}

Status ChildLink::reset(const std::array<std::uint64_t, 4>& random, std::span<const double> parameters,
                        std::span<double> numbers) {
  std::vector<std::byte> content(sizeof random + parameters.size_bytes());
  std::memcpy(content.data(), random.data(), sizeof random);
  if (!parameters.empty()) std::memcpy(content.data() + sizeof random, parameters.data(), parameters.size_bytes());
  if (const Status s = send(FrameKind::Reset, content); !s) return s;
  std::fill_n(numbers.begin(), ChildSpec::kOwn, 0.0);
  const auto own = numbers.subspan(ChildSpec::kOwn);
  if (const Status s = receive(FrameKind::Reset, std::as_writable_bytes(own), kAnswerPatience); !s) return s;
  return check(numbers);
}

Status ChildLink::step(std::span<const double> levels, std::span<double> numbers) {
  if (const Status s = send(FrameKind::Step, std::as_bytes(levels)); !s) return s;
  if (const Status s = receive(FrameKind::Step, std::as_writable_bytes(numbers), kAnswerPatience); !s) return s;
  return check(numbers);
}

}  // namespace surefoot
