// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot new`: a robot's file that begins as a copy of another.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands/commands.h"
#include "app/process/resources.h"
#include "core/environment_library.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "physics/robot/reading/robot_text.h"

namespace surefoot {

namespace {

/// The robots that come with the program, by the names of their files.
std::vector<std::string> shippedRobots() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(resourceFolder("robots"), error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<std::string> textLike(const std::string& like) {
  if (isEnvironmentPath(like)) return readText(like);
  const auto names = shippedRobots();
  if (std::find(names.begin(), names.end(), like) != names.end())
    return readText((std::filesystem::path(resourceFolder("robots")) / (like + ".toml")).string());
  return Error{unknownName("--like", like, names).message};
}

}  // namespace

int newRobotCommand(const NewRobotRequest& request) {
  const std::filesystem::path path(request.name);
  const std::string name = path.stem().string();
  if (const char* why = wrongRobotName(name))
    return fail({fmt::format("new: \"{}\": {}", printable(shortened(name)), why)});
  const auto text = textLike(request.like);
  if (!text) return fail(text.error());
  const std::string file = (path.parent_path() / (name + ".toml")).string();
  auto place = WholeFile::createNew("robot", file);
  if (!place) return fail(place.error());
  if (const Status s = place->commit(renamedRobot(*text, name)); !s) return fail(s.error());
  return print(fmt::format("{0}: like {1}. Edit it, then: surefoot check {0}; surefoot window --environment {0}\n",
                           file, request.like));
}

}  // namespace surefoot
