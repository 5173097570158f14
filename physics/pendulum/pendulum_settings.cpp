// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/pendulum/pendulum_settings.h"

namespace surefoot {

namespace {
constexpr auto kModel = Group::Model;
constexpr auto kRewards = Group::Rewards;
constexpr auto kNext = When::NextEpisode;
}  // namespace

void PendulumSettings::declare(Fields& f) {
  f.real(goalReward, {.key = "goal_reward", .title = "Goal", .low = -1e6, .high = 1e6, .sliderLow = 0, .sliderHigh = 400,
                      .when = When::Now, .group = kRewards, .help = "Reward for balancing the pole.",
                      .origin = "thesis, section 3.1.1"});
  f.real(fallReward, {.key = "fall_reward", .title = "Fall", .low = -1e6, .high = 1e6, .sliderLow = -400, .sliderHigh = 0,
                      .when = When::Now, .group = kRewards, .help = "Reward for letting the pole fall.",
                      .origin = "thesis, section 3.1.1 (−400 from section 6.2 on)"});
  f.real(timeReward, {.key = "time_reward", .title = "Time", .low = -1e6, .high = 1e6, .sliderLow = -5, .sliderHigh = 0,
                      .when = When::Now, .group = kRewards, .help = "Reward of every step; 0 or below.",
                      .origin = "thesis, section 3.1.1 (none)"});
  f.real(damping, {.key = "damping", .title = "Damping", .symbol = "c", .unit = "N m s", .low = 0, .high = 10,
                   .sliderLow = 0, .sliderHigh = 0.2, .when = kNext, .group = kModel,
                   .help = "Linear damping of the wheel motors, per rad.", .origin = "thesis, table 4.1"});
  f.real(friction, {.key = "friction", .title = "Friction", .symbol = "μ", .unit = "N m", .low = 0, .high = 10,
                    .sliderLow = 0, .sliderHigh = 0.1, .when = kNext, .group = kModel,
                    .help = "Dry friction on the hinge of the pole.", .origin = "thesis, table 4.1"});
  f.real(torqueScale, {.key = "torque_scale", .title = "Torque", .unit = "×", .low = 0.01, .high = 100,
                       .sliderLow = 0.25, .sliderHigh = 3, .when = kNext, .group = kModel,
                       .help = "Multiplies the torque of every action.", .origin = "thesis, table 4.1"});
  f.real(poleLength, {.key = "pole_length", .title = "Pole length", .unit = "m", .low = 0.01, .high = 10,
                      .sliderLow = 0.05, .sliderHigh = 0.5, .when = kNext, .group = kModel, .help = "Length of the pole.",
                      .origin = "calibrated", .order = 2});
  f.real(poleMass, {.key = "pole_mass", .title = "Pole mass", .unit = "kg", .low = 0.001, .high = 100,
                    .sliderLow = 0.1, .sliderHigh = 2, .when = kNext, .group = kModel,
                    .help = "Mass of the pole, a uniform rod.", .origin = "calibrated", .order = 2});
  f.real(baseMass, {.key = "base_mass", .title = "Base mass", .unit = "kg", .low = 0.001, .high = 1000,
                    .sliderLow = 0.2, .sliderHigh = 5, .when = kNext, .group = kModel,
                    .help = "Mass of the cart without its wheel.", .origin = "calibrated", .order = 2});
  f.real(startAngle, {.key = "start_angle", .title = "Start angle", .unit = "rad", .low = 0, .high = 1.5,
                      .sliderLow = 0, .sliderHigh = 0.6, .when = kNext, .group = kModel,
                      .help = "An episode starts at rest, anywhere within ± this angle.", .origin = "calibrated", .order = 2});
  f.integer(substeps, {.key = "substeps", .title = "Substeps", .low = 1, .high = 100, .sliderLow = 1, .sliderHigh = 10,
                       .when = kNext, .group = kModel, .help = "Steps of the simulation in one transition.",
                       .origin = "ours", .order = 2});
  f.real(wheelRadius, {.key = "wheel_radius", .title = "Wheel radius", .unit = "m", .low = 0.005, .high = 1,
                       .sliderLow = 0.02, .sliderHigh = 0.1, .when = kNext, .group = kModel,
                       .help = "Radius of the driven wheel.", .origin = "lab file", .order = 3});
  f.real(wheelMass, {.key = "wheel_mass", .title = "Wheel mass", .unit = "kg", .low = 0.001, .high = 100,
                     .sliderLow = 0.1, .sliderHigh = 2, .when = kNext, .group = kModel,
                     .help = "Mass of the driven wheel, a solid cylinder.", .origin = "lab file", .order = 3});
  f.real(fallAngle, {.key = "fall_angle", .title = "Fall angle", .unit = "rad", .low = 0.05, .high = 1.55,
                     .sliderLow = 0.3, .sliderHigh = 1.55, .when = kNext, .group = kModel,
                     .help = "The pole has fallen at this angle.", .origin = "thesis, section 3.1.1", .order = 3});
  f.real(balancedAngle, {.key = "balanced_angle", .title = "Balanced angle", .unit = "rad", .low = 1e-6, .high = 1,
                         .sliderLow = 0.001, .sliderHigh = 0.1, .when = kNext, .group = kModel,
                         .help = "Balanced: the angle is at most this, and the rate as well.",
                         .origin = "thesis, section 3.1.1", .order = 3});
  f.real(balancedRate, {.key = "balanced_rate", .title = "Balanced rate", .unit = "rad/s", .low = 1e-6, .high = 10,
                        .sliderLow = 0.001, .sliderHigh = 0.1, .when = kNext, .group = kModel,
                        .help = "Balanced: the rate is at most this, and the angle as well.",
                        .origin = "thesis, section 3.1.1", .order = 3});
  f.integer(maxSteps, {.key = "max_steps", .title = "Step limit", .low = 1, .high = 1000000000, .sliderLow = 100,
                       .sliderHigh = 10000, .when = kNext, .group = kModel,
                       .help = "An episode is cut off after this many steps; that is not a fall.", .origin = "ours", .order = 3});
  f.real(wheelSpan, {.key = "wheel_span", .title = "Wheel span", .unit = "rad/s", .low = 0.1, .high = 1000,
                     .sliderLow = 5, .sliderHigh = 40, .when = When::NewTable, .group = Group::Representation,
                     .help = "The span of the wheel rate that its tiles are counted in: 20 rad/s is 1 m/s of the cart.",
                     .origin = "thesis, section 6.2.1 (\"per m/s\")", .order = 3});
}

}  // namespace surefoot
