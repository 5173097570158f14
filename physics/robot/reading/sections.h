// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a robot's file, one function each: part of readRobot(). Names are known before they are called.
#pragma once

#include "physics/robot/reading/robot_reader.h"

namespace surefoot {

inline constexpr int kMostBodies = 64, kMostJoints = 64, kMostShapes = 256, kMostCorners = 8, kMostGroundPoints = 2000,
                     kMostParameters = 200, kMostNames = 4000, kMostLevels = 101, kMostRays = 64;

/// Gives every name of the file its kind and number.
void collectNames(const TomlNode& root, RobotReader& in);

void readParameters(const TomlNode& root, RobotReader& in);
void readConstants(const TomlNode& root, RobotReader& in);
/// `command` and `sends`, before the names are collected.
void readChild(const TomlNode& root, RobotReader& in);
/// What a program that moves the robot leaves no room for.
void refuseWorld(const TomlNode& root, RobotReader& in);
void readBodies(const TomlNode& root, RobotReader& in);
void readPoints(const TomlNode& root, RobotReader& in);
void readJoints(const TomlNode& root, RobotReader& in);
void readActuators(const TomlNode& root, RobotReader& in);
void readGround(const TomlNode& root, RobotReader& in);
void readMemories(const TomlNode& root, RobotReader& in);
void readStates(const TomlNode& root, RobotReader& in);
void readStart(const TomlNode& root, RobotReader& in);
void readEndings(const TomlNode& root, RobotReader& in);
void readRewards(const TomlNode& root, RobotReader& in);
void readPicture(const TomlNode& root, RobotReader& in);
/// [preset.N], [scenario.N] and [learning].
void readSettings(const TomlNode& root, RobotReader& in);

/// Shapes of a body; `ink` is the body's.
std::vector<ShapeSpec> readShapes(TomlReader& body, RobotReader& in, const ShapeSpec& usual);

}  // namespace surefoot
