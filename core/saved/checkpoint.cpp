// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/checkpoint.h"

#include <fmt/format.h>

#include "core/basics/expects.h"
#include "core/experiment/configuration_json.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"
#include "core/saved/teacher_file.h"

namespace surefoot {

namespace {

Json changesAsJson(const std::vector<Change>& changes) {
  Json list = Json::array();
  for (const Change& c : changes)
    list.push_back({{"step", c.step}, {"key", c.key}, {"before", c.before}, {"after", c.after}});
  return list;
}

/// By their steps, from 0 on.
template <class Step>
bool inOrder(const std::vector<Step>& list) {
  std::int64_t least = 0;
  for (const Step& entry : list) {
    if (entry.step < least || entry.step > kMostLifeSteps) return false;
    least = entry.step;
  }
  return true;
}

std::optional<std::vector<Change>> changesFrom(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<Change> changes;
  for (const Json& entry : json) {
    if (!entry.is_object()) return std::nullopt;
    const auto text = [&](const char* key) { return entry.contains(key) && entry[key].is_string(); };
    if (!entry.contains("step") || !entry["step"].is_number_integer() || !text("key") || !text("before") ||
        !text("after"))
      return std::nullopt;
    changes.push_back({entry["step"].get<std::int64_t>(), entry["key"].get<std::string>(),
                       entry["before"].get<std::string>(), entry["after"].get<std::string>()});
  }
  if (changes.size() > kMostChanges || !inOrder(changes)) return std::nullopt;
  return changes;
}

Json commandsAsJson(const std::vector<CommandText>& commands) {
  Json list = Json::array();
  for (const CommandText& c : commands) list.push_back({{"step", c.step}, {"key", c.key}, {"value", c.value}});
  return list;
}

std::optional<std::vector<CommandText>> commandsFrom(const Json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<CommandText> commands;
  for (const Json& entry : json) {
    if (!entry.is_object() || !entry.contains("step") || !entry["step"].is_number_integer() || !entry.contains("key") ||
        !entry["key"].is_string() || !entry.contains("value") || !entry["value"].is_string())
      return std::nullopt;
    commands.push_back(
        {entry["step"].get<std::int64_t>(), entry["key"].get<std::string>(), entry["value"].get<std::string>()});
  }
  if (!inOrder(commands)) return std::nullopt;
  return commands;
}

bool isBeginning(const Json& json) {
  if (!json.is_object() || !json.contains("file") || !json["file"].is_string()) return false;
  const char* which = json.contains("content") ? "content" : "hash";  // hash of the values; formerly of the file
  return json.contains(which) && json[which].is_string();
}

int versionOf(const TensorFile& file) {
  const Json version = file.about.value("lives_version", Json());
  return version.is_number_integer() ? version.get<int>() : kLivesVersionUnknown;
}

/// Notes that another version goes on from here, or refuses to.
Status checkVersion(const TensorFile& file, Versions versions, std::vector<Change>& changes) {
  const Status same = checkLivesVersion(file);
  if (same || versions == Versions::Same) return same;
  const Json learned = file.about.value("learned", Json::object());
  const Json steps = learned.is_object() ? learned.value("steps", Json(0)) : Json(0);
  changes.push_back({steps.is_number_integer() ? steps.get<std::int64_t>() : 0, kOtherLives,
                     std::to_string(versionOf(file)), std::to_string(kLivesVersion)});
  return Done{};
}

/// Everything that resume() reads from the description. Objects that are missing there are null.
struct Description {
  Json parameters, inForce, policy, changes, commands, keepRows;
  explicit Description(const Json& about) {
    const Json now = about.value("now", Json::object());
    const auto get = [&](const char* key) { return now.is_object() && now.contains(key) ? now[key] : Json(nullptr); };
    parameters = get("parameters");
    inForce = get("environment_in_force");
    policy = get("policy");
    changes = get("changes");
    commands = about.value("commands", Json::array());
    keepRows = about.value("keep_rows", Json(false));
  }
};

}  // namespace

TensorFile checkpointOf(const Life& life, const Configuration& configuration, bool keepRows) {
  TensorFile file;
  file.about = qFileOf(life, configuration).about;
  file.about["kind"] = "checkpoint";
  file.about["configuration"] = Json(configurationAsJson(configuration));
  file.about["commands"] = commandsAsJson(configuration.commands);
  file.about["keep_rows"] = keepRows;
  Json inForce = Json::object();
  for (const auto& [key, value] : life.environmentInForce()) inForce[key] = value;
  file.about["now"] = {{"parameters", Json(parametersAsJson(life.parameters()))},
                       {"environment_in_force", inForce},
                       {"policy", life.policyName()},
                       {"changes", changesAsJson(life.changes())}};
  Archive archive = Archive::writer(file);
  life.save(archive);
  expects(archive.good(), "a life can be saved");
  if (configuration.teacher) packTeacher(file, *configuration.teacher);
  seal(file);
  return file;
}

Status checkLivesVersion(const TensorFile& file) {
  if (versionOf(file) == kLivesVersion) return Done{};
  const Json program = file.about.value("program", Json());
  return otherLives(file.name, versionOf(file), program.is_string() ? program.get<std::string>() : "");
}

Result<Resumed> resume(const Registry& registry, std::shared_ptr<const TensorFile> file, const NewLimits& limits,
                       Versions versions) {
  if (const Status s = checkKind(*file, {"checkpoint"}); !s) return s.error();
  auto configuration = configurationOf(registry, *file);
  if (!configuration) return configuration.error();
  if (!configuration->otherProgram.empty() && versions == Versions::Same)
    return fileError(file->name, fmt::format("the program of its robot was another one: {} there, {} here. With "
                                             "--other-version the life goes on all the same.",
                                             configuration->otherProgram, configuration->names.environment));
  const Description d(file->about);
  auto changes = changesFrom(d.changes);
  if (!changes || !d.policy.is_string() || !d.keepRows.is_boolean())
    return fileError(file->name, "its description lacks what happened to the life; the file is damaged.");
  if (const Status s = checkVersion(*file, versions, *changes); !s) return s.error();
  configuration->beganWith = file->about.value("began_with", Json());
  if (!configuration->beganWith.is_null() && !isBeginning(configuration->beganWith))
    return fileError(file->name, "what it says of the file that the life began with is damaged.");
  configuration->beganWith = withoutFolders(std::move(configuration->beganWith));
  if (limits.minutes) configuration->minutes = limits.minutes;
  if (limits.episodes) configuration->episodes = limits.episodes;
  if (auto commands = commandsFrom(d.commands))
    configuration->commands = std::move(*commands);
  else
    return fileError(file->name, "its list of commands is damaged.");

  // The parameters set now, and the environment's parameters in force in this episode.
  Configuration now = *configuration;
  now.names.policy = d.policy.get<std::string>();
  now.start = file;
  if (const Status s = setParameters(now.parameters, d.parameters, file->name); !s) return s.error();
  Configuration inForce = now;
  if (const Status s = setParameters(inForce.parameters, d.inForce, file->name); !s) return s.error();

  const bool keepRows = d.keepRows.get<bool>();
  Archive archive = Archive::reader(*file);
  auto life = resumeLife(registry, now, inForce, keepRows, *changes, archive);
  if (!life) {
    const Error& e = life.error();
    return e.message.starts_with(file->name) ? e : fileError(file->name, e.message);
  }
  return Resumed{std::move(*configuration), std::move(*life), keepRows};
}

}  // namespace surefoot
