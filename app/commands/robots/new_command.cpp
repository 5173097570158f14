// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot new`: a robot's file that begins as a copy of another.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/commands/commands.h"
#include "core/environment_library.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/text/printable.h"
#include "core/text/text.h"
#include "core/text/words.h"
#include "physics/robot/reading/robot_text.h"

namespace surefoot {

namespace {

/// The text of a file, or of a robot that comes with the program.
Result<std::string> textLike(const EnvironmentLibrary& robots, const std::string& like) {
  if (isEnvironmentPath(like)) return readText(like);
  if (const std::string path = robots.shelvedPath(like); !path.empty()) return readText(path);
  return Error{unknownName("--like", like, robots.shelved()).message};
}

}  // namespace

int newRobotCommand(const Registry& registry, const NewRobotRequest& request) {
  const std::filesystem::path path(request.name);
  const std::string name = path.stem().string();
  if (const std::string why = wrongRobotName(name); !why.empty())
    return fail({fmt::format("new: \"{}\": {}", printable(shortened(name)), why)});
  const auto text = textLike(*registry.files, request.like);
  if (!text) return fail(text.error());
  const std::string file = (path.parent_path() / (name + ".toml")).string();
  auto place = WholeFile::createNew("robot", file);
  if (!place) return fail(place.error());
  if (const Status s = place->commit(renamedRobot(*text, name)); !s) return fail(s.error());
  return print(fmt::format("{0}: like {1}. Edit it, then: surefoot check {0}; surefoot window --environment {0}\n",
                           file, request.like));
}

}  // namespace surefoot
