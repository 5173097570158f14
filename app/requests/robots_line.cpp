// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/robots_line.h"

#include "app/requests/requests.h"

namespace surefoot {

RobotsLine::RobotsLine(CLI::App& app)
    : check(app.add_subcommand("check", "what a robot's file describes, and what is doubtful in it")),
      create(app.add_subcommand("new", "begin a robot's file like one that comes with the program")) {
  check
      ->add_option("FILE", checkRequest.file,
                   "a robot's file, NAME.toml, or the name of one that comes with the program")
      ->type_name("");
  for (CLI::App* command : {check, create})
    command->footer("The format of the file: robots/format.md among the program's resources; F1 on the page Robot.");
  check->add_flag("--json", checkRequest.json, "as JSON");
  create->add_option("NAME", newRequest.name, "the robot's name; its file is NAME.toml, and must not exist yet")
      ->type_name("");
  create->add_option("--like", newRequest.like, "a robot that comes with the program, or a robot's file")
      ->type_name("ROBOT")
      ->capture_default_str();
}

std::optional<Result<Request>> RobotsLine::request() const {
  if (check->parsed()) {
    if (checkRequest.file.empty()) return Result<Request>(Error{"check: the file of a robot is needed."});
    return Result<Request>(Request(checkRequest));
  }
  if (!create->parsed()) return std::nullopt;
  if (newRequest.name.empty())
    return Result<Request>(Error{"new: a name is needed, e.g. `surefoot new roller --like segway`."});
  return Result<Request>(Request(newRequest));
}

}  // namespace surefoot
