// SPDX-License-Identifier: GPL-3.0-or-later
// What `surefoot check` prints of a robot.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "physics/robot/inspection/inspection.h"

namespace surefoot {

std::string robotReport(const RobotSpec& spec, const EnvironmentInspection& found, const std::string& file);
nlohmann::ordered_json robotReportAsJson(const RobotSpec& spec, const EnvironmentInspection& found);
/// "line", "column" and "sentence" of each.
nlohmann::ordered_json complaintsAsJson(const std::vector<Complaint>& complaints);

}  // namespace surefoot
