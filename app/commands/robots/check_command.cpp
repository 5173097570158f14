// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot check`: reads a robot's file, lets the robot move at random and by itself, and tells what is doubtful.
#include <fmt/format.h>

#include <filesystem>

#include "app/commands/commands.h"
#include "app/commands/robots/robot_report.h"
#include "app/process/exit_code.h"
#include "core/basics/typed_json.h"
#include "core/environment_library.h"
#include "core/environment_programs.h"
#include "core/files/read_file.h"
#include "physics/robot/reading/robot_reading.h"

namespace surefoot {

namespace {

/// All that is wrong, a line each on standard error.
int tellWrong(const CheckRequest& request, const std::vector<Complaint>& complaints) {
  if (request.json) {
    const nlohmann::ordered_json json = {{"file", request.file}, {"errors", complaintsAsJson(complaints)}};
    if (const int code = print(jsonText(json, 2) + "\n"); code != kDone) return code;
    return kFile;
  }
  for (const Complaint& c : complaints) fail(Error{complaintLine(request.file, c), ErrorKind::File});
  return kFile;
}

}  // namespace

int checkCommand(const Registry& registry, const CheckRequest& asked) {
  CheckRequest request = asked;
  if (const std::string path = registry.files->shelvedPath(request.file); !path.empty())
    request.file = path;
  else if (const Status s = checkEnding("check", request.file); !s)
    return fail(s.error());
  else if (!isEnvironmentPath(request.file) && !std::filesystem::exists(request.file))
    return fail(unknownName("check", request.file, registry.files->shelved()));
  const auto text = readText(request.file);
  if (!text) return fail({text.error().message, ErrorKind::File});
  std::vector<Complaint> complaints;
  const auto file = registry.files->read(*text, std::filesystem::absolute(request.file).parent_path(), complaints);
  if (!file) return tellWrong(request, complaints);
  const auto spec = readRobot(*text, complaints);
  const EnvironmentInspection found = file->inspect();
  if (!found.unanswered.empty())
    return fail({found.unanswered, registry.programs->isStopped() ? ErrorKind::Interrupted : ErrorKind::Unanswered});
  if (!request.json) return print(robotReport(*spec, found, request.file));
  auto json = robotReportAsJson(*spec, found);
  json["errors"] = nlohmann::ordered_json::array();
  json["warnings"] = complaintsAsJson(found.warnings);
  return print(jsonText(json, 2) + "\n");
}

}  // namespace surefoot
