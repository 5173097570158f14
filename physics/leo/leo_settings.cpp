// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/leo/leo_settings.h"

#include "physics/world/walking.h"

namespace surefoot {

namespace {

Parameter model(const char* key, const char* title, const char* symbol, const char* unit, double low, double high,
                const char* help, const char* origin = kLeosim, int order = 2) {
  return {.key = key,
          .title = title,
          .symbol = symbol,
          .unit = unit,
          .low = low,
          .high = high,
          .sliderLow = low,
          .sliderHigh = high,
          .when = When::NextEpisode,
          .group = Group::Model,
          .help = help,
          .origin = origin,
          .order = order};
}

}  // namespace

void LeoSettings::declare(Fields& f) {
  f.real(footstepReward, rewardParameter("footstep_reward", "Footstep", 0, 600,
                                         "Reward of a metre by which the ankles part.", kLeosim, "1/m"));
  f.real(energyReward, rewardParameter("energy_reward", "Energy", -10, 0, "Reward of a joule that hips and knees take.",
                                       kLeosim, "1/J"));
  f.real(fallReward, fallParameter("Reward for being doomed to fall.", kLeosim));
  f.real(timeReward, rewardParameter("time_reward", "Time", -5, 0, "Reward of every step.", kLeosim));
  f.real(resistance, model("resistance", "Resistance", "R", "Ω", 1, 100, "Of a motor's windings.", kLeosim, 1));
  f.real(dryFriction, model("dry_friction", "Dry friction", "F", "N m", 0, 2, "Of every joint.", kLeosim, 1));
  f.real(torqueConstant, model("torque_constant", "Torque constant", "k", "N m/A", 1e-4, 1, "Of a motor."));
  f.real(gearRatio, model("gear_ratio", "Gear ratio", "G", "", 1, 2000, "Of a motor."));
  f.real(armature, model("armature", "Armature", "J", "kg m²", 0, 1, "Inertia of a rotor as the joint feels it."));
  f.real(gravity, model("gravity", "Gravity", "g", "m/s²", 0, 30, "On the Earth 9.81."));
  f.real(stanceKneeGain, model("stance_knee_gain", "Stance knee", "", "V/rad", 0, 200,
                               "Voltage by which the stance knee stretches itself."));
  f.real(ankleGain, model("ankle_gain", "Ankles", "", "V/rad", 0, 200, "Voltage by which ankles hold their angle."));
  f.real(ankleTarget, model("ankle_target", "Ankle target", "", "rad", -1, 1, "The angle that the ankles hold."));
  f.real(mostTorso, model("fall_torso", "Fall, torso", "", "rad", 0.1, 3, "Doomed beyond this lean of the torso."));
  Parameter thigh = model("fall_stance_thigh", "Fall, stance thigh", "", "rad", 0.1, 3,
                          "Doomed beyond this lean of the stance thigh: 0.36π.");
  thigh.label = "Fall, thigh";
  f.real(mostStanceThigh, thigh);
  f.real(efficiency, model("efficiency", "Efficiency", "η", "", 0.05, 1, "Of the gears."));

  f.real(boomForce, model("boom_force", "Boom force", "", "N", -20, 20, "What the boom adds, upwards positive."));
  f.real(grip, model("contact_friction", "Grip", "", "", 0.01, 100, "Of feet and floor.", "ours", 3));
  f.real(hipTarget, model("hip_target", "Hip target", "", "rad", 0, 1.5,
                          "The angle between the hips that the hand-made controller aims at.", kLeosim, 3));
  f.integer(substeps,
            model("substeps", "Substeps", "", "", 1, 1000, "Steps of the simulation in one transition.", "ours", 3));
  anatomy.declare(f);
  f.integer(maxSteps, model("max_steps", "Step limit", "", "", 1, 1e9, "An episode is cut off after so many; no fall.",
                            kLeosim, 3));
  f.integer(testEvery, testParameter());
  Parameter most = model("voltage", "Voltage", "U", "V", 1, 30, "The largest; actions are levels between ± this.");
  most.when = When::NewTable;  // the tiles of actions belong to their voltages
  most.group = Group::Representation;
  f.real(voltage, most);
  Parameter levelsOf =
      model("levels", "Levels", "", "", 2, 15, "Of each voltage; actions are their combinations.", kLeosim, 3);
  levelsOf.when = When::NewTable;
  levelsOf.group = Group::Representation;
  f.integer(levels, levelsOf);
}

}  // namespace surefoot
