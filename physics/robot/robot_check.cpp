// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "physics/robot/robot.h"

namespace surefoot {

namespace {

class ValueCheck {
 public:
  ValueCheck(const RobotSpec& spec, std::vector<Complaint>& complaints) : spec_(spec), complaints_(complaints) {}

  void all() {
    values_.assign(static_cast<std::size_t>(spec_.names.places()), 0.0);
    std::copy(spec_.defaults.begin(), spec_.defaults.end(), values_.begin());
    constants();
    if (!complaints_.empty()) return;
    const RobotNumbers numbers = numbersOf(spec_, values_, complaints_);
    states();
    picture();
    if (complaints_.empty()) loops(numbers);
  }

 private:
  void constants() {
    for (std::size_t c = 0; c < spec_.constants.size(); ++c) {
      const ConstantSpec& constant = spec_.constants[c];
      const double value = constant.value(values_);
      values_[static_cast<std::size_t>(spec_.names.placeOf(NameKind::Constant, static_cast<int>(c)))] = value;
      if (!std::isfinite(value))
        complaints_.push_back(
            {constant.value.at, fmt::format("{}: it comes to {}, which is no finite number.", constant.name, value)});
    }
  }
  void states() {
    for (const StateSpec& state : spec_.states) {
      const double low = state.range[0](values_), high = state.range[1](values_);
      if (!(low < high && std::isfinite(low) && std::isfinite(high)))
        complaints_.push_back(
            {state.place, fmt::format("range: the lowest, {}, must be below the highest, {}.", low, high)});
      for (const auto* positive : {&state.width, &state.resolution, &state.span})
        if (*positive && !((**positive)(values_) > 0.0 && std::isfinite((**positive)(values_))))
          complaints_.push_back({(**positive).at, fmt::format("{} = {}; it must be above 0.",
                                                              positive == &state.width        ? "width"
                                                              : positive == &state.resolution ? "resolution"
                                                                                              : "span",
                                                              (**positive)(values_))});
    }
  }
  void picture() {
    constexpr double kLeast = 0.001, kMost = 10'000;  // [m]
    for (const auto& [name, length] :
         {std::pair{"height", &spec_.picture.height}, std::pair{"width", &spec_.picture.width}})
      if (const double metres = *length ? (**length)(values_) : kMost; !(metres >= kLeast && metres <= kMost))
        complaints_.push_back(
            {(**length).at, fmt::format("{} = {}; allowed is {} … {} m.", name, metres, kLeast, kMost)});
  }
  void loops(const RobotNumbers& numbers) {
    constexpr double kClosed = 1e-3;  // [m]
    constexpr int kStarts = 20;
    const Assembly assembly(spec_, numbers);
    Random random(1);
    for (int i = 0; i < kStarts && !assembly.closing().empty(); ++i) {
      const auto bodies = assembly.start(values_, random);
      for (const int joint : assembly.closing())
        if (const double gap = assembly.gap(joint, bodies); gap > kClosed) {
          const JointSpec& spec = spec_.joints[static_cast<std::size_t>(joint)];
          return complaints_.push_back({spec.place, fmt::format("[joint.{}] closes a loop, and at the start its ends "
                                                                "are {:.3g} m apart; begin in a pose that closes it.",
                                                                spec.name, gap)});
        }
    }
  }

  const RobotSpec& spec_;
  std::vector<Complaint>& complaints_;
  std::vector<double> values_;
};

}  // namespace

std::vector<Complaint> checkRobot(const RobotSpec& spec) {
  std::vector<Complaint> complaints;
  ValueCheck(spec, complaints).all();
  return complaints;
}

}  // namespace surefoot
