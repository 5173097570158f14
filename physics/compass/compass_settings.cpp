// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/compass/compass_settings.h"

#include "physics/world/walking.h"

namespace surefoot {

namespace {

/// A number of the model: its range on the slider is a tenth to three times the usual value.
Parameter model(const char* key, const char* title, const char* unit, double usual, const char* help, int order = 2) {
  return {.key = key,
          .title = title,
          .unit = unit,
          .low = 1e-4,
          .high = 100,
          .sliderLow = 0.1 * usual,
          .sliderHigh = 3 * usual,
          .when = When::NextEpisode,
          .group = Group::Model,
          .help = help,
          .origin = "ours",
          .order = order};
}

Parameter signedModel(Parameter p, double low, double high, double sliderLow, double sliderHigh) {
  p.low = low, p.high = high, p.sliderLow = sliderLow, p.sliderHigh = sliderHigh;
  return p;
}

}  // namespace

void CompassSettings::declare(Fields& f) {
  f.real(footstepReward, rewardParameter("footstep_reward", "Footstep", 0, 500,
                                         "Reward of a footstep, a metre of its length.", "ours", "1/m"));
  f.real(fallReward, fallParameter("Reward for falling.", "ours"));
  f.real(timeReward, rewardParameter("time_reward", "Time", -5, 0, "Reward of every step; 0 or below.", "ours"));
  f.real(slope, signedModel(model("slope", "Slope", "rad", 0, "Of the floor: below 0 it goes uphill.", 1), -0.3, 0.3,
                            -0.05, 0.05));
  f.real(torque, model("torque", "Torque", "N m", torque, "Of the hip; the actions are −, 0 and + this.", 1));
  f.real(hipMass, model("hip_mass", "Hip mass", "kg", hipMass, "Half of it sits on each leg, at the hip.", 1));
  f.real(legMass, model("leg_mass", "Leg mass", "kg", legMass, "Of one leg, its centre in the middle."));
  f.real(legLength, model("leg_length", "Leg length", "m", legLength, "From the hip to the sole."));
  f.real(legInertia, model("leg_inertia", "Leg inertia", "kg m²", legInertia, "Of one leg about its centre.", 3));
  f.real(footRadius, signedModel(model("foot_radius", "Foot radius", "m", footRadius, "The feet are round.", 3), 0.001,
                                 0.2, 0.005, 0.05));
  f.real(friction, model("contact_friction", "Grip", "", friction, "Of feet and floor.", 3));
  f.real(startStance,
         signedModel(model("start_stance", "Start stance", "rad", 0, "Angle of the stance leg at the start.", 3), -0.45,
                     0.45, 0, 0.4));
  f.real(startRate,
         signedModel(model("start_rate", "Start rate", "rad/s", 0, "Rate of the stance leg at the start.", 3), -10, 10,
                     -3, 0));
  f.real(startSwing,
         signedModel(model("start_swing", "Start swing", "rad", 0, "Angle of the swing leg at the start.", 3), -0.9,
                     0.9, -0.4, 0));
  f.real(startNoise, signedModel(model("start_noise", "Start noise", "", 0,
                                       "Share by which start angles and rates vary; in rad/s that of the swing leg."),
                                 0, 1, 0, 0.5));
  f.real(gravity, signedModel(model("gravity", "Gravity", "m/s²", gravity, "On the Earth 9.81."), 0, 30, 0, 30));
  f.real(solidFrom,
         signedModel(model("solid_from", "Solid from", "rad", solidFrom,
                           "The swing foot meets the floor from this angle in front of the stance leg on.", 3),
                     0, 0.4, 0, 0.4));
  f.real(mostStance, signedModel(model("fall_stance", "Fall, stance leg", "rad", mostStance,
                                       "It has fallen beyond this angle of the stance leg.", 3),
                                 0.1, 1.5, 0.1, 1.5));
  f.real(mostSwing, signedModel(model("fall_swing", "Fall, swing leg", "rad", mostSwing,
                                      "It has fallen beyond this angle of the swing leg.", 3),
                                0.1, 2.5, 0.1, 2.5));
  Parameter substepsOf = model("substeps", "Substeps", "", 1, "Steps of the simulation in one transition.", 3);
  f.integer(substeps, signedModel(substepsOf, 1, 1000, 10, 80));
  Parameter limit = model("max_steps", "Step limit", "", 1, "An episode is cut off after so many steps; no fall.", 3);
  f.integer(maxSteps, signedModel(limit, 1, 1e9, 100, 2000));
  f.integer(testEvery, testParameter());
}

}  // namespace surefoot
