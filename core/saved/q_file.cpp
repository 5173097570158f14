// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/saved/q_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/experiment/configuration_json.h"
#include "core/experiment/task_description.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file_tensors.h"
#include "core/saved/teacher_file.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

constexpr const char* kFormat = "1.0";

void add(Hash64& hash, std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
    hash.add(word);
  }
}

/// 64 bits over the tensors.
std::string checksumOf(const TensorFile& file) {
  Hash64 hash;
  std::vector<const Tensor*> tensors;  // by name: the order of empty tensors does not matter
  for (const Tensor& tensor : file.tensors) tensors.push_back(&tensor);
  std::sort(tensors.begin(), tensors.end(), [](const Tensor* a, const Tensor* b) { return a->name < b->name; });
  for (const Tensor* tensor : tensors) {
    add(hash, tensor->name);
    add(hash, tensor->bytes);
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace

// A checkpoint holds more than values; tensors of an estimate begin with its name.
std::string contentOf(const TensorFile& file) {
  const Json estimates = file.about.value("estimates", Json::object());
  const auto isValue = [&](const Tensor& t) {
    return !estimates.is_object() || estimates.contains(t.name.substr(0, t.name.find('.')));
  };
  TensorFile values;
  std::copy_if(file.tensors.begin(), file.tensors.end(), std::back_inserter(values.tensors), isValue);
  return checksumOf(values);
}

TensorFile qFileOf(Agent& agent, const Task& task, const Configuration& configuration, const Json& origin) {
  TensorFile file;
  file.about = {{"kind", "q-function"},
                {"format", kFormat},
                {"program", kVersion},
                {"lives_version", kLivesVersion},
                {"configuration", Json(configurationAsJson(configuration))},
                {"seed", configuration.seed},
                {"state", stateAsJson(task)},
                {"actions", actionsAsJson(task)},
                {"estimates", agent.layouts()},
                {"learned", origin}};
  file.about["began_with"] = configuration.beganWith;
  Archive archive = Archive::writer(file);
  agent.transferValues(archive);
  seal(file);
  return file;
}

TensorFile qFileOf(const Life& life, const Configuration& configuration) {
  Configuration now = configuration;
  now.parameters = life.parameters();
  now.names.policy = life.policyName();
  Json origin = {{"steps", life.steps()},
                 {"episodes", life.log().totals().episodes},
                 {"falls", life.log().totals().falls},
                 {"average_reward", life.log().averageReward()},
                 {"hash", fmt::format("{:016x}", life.hash())}};
  if (const std::int64_t rewinds = life.log().totals().rewinds; rewinds > 0) origin["rewinds"] = rewinds;
  return qFileOf(const_cast<Agent&>(life.agent()), life.environment().task(), now, origin);  // a writer changes nothing
}

void seal(TensorFile& file) {
  file.about["checksum"] = checksumOf(file);
}

Status checkKind(const TensorFile& file, const std::vector<std::string>& kinds) {
  const auto text = [&](const char* key) {
    return file.about.contains(key) && file.about[key].is_string() ? file.about[key].get<std::string>() : "";
  };
  const std::string format = text("format"), kind = text("kind");
  if (!format.starts_with("1."))
    return fileError(file.name,
                     fmt::format("its format is \"{}\"; this version of Surefoot reads 1.x.", shortened(format)));
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    return fileError(file.name,
                     fmt::format("it is of the kind \"{}\"; a {} is needed.", shortened(kind), joinWords(kinds, "or")));
  return Done{};
}

namespace {

Status checkHead(const TensorFile& head) {
  const Status s = checkKind(head, {"q-function", "checkpoint"});
  return s ? checkTensors(head) : s;
}

Result<std::shared_ptr<const TensorFile>> withRightSum(TensorFile file) {
  if (file.about.contains("checksum") && file.about["checksum"] != checksumOf(file))
    return fileError(file.name, "its data does not match its checksum; the file is damaged.");
  return std::make_shared<const TensorFile>(std::move(file));
}

}  // namespace

Result<std::shared_ptr<const TensorFile>> readQFile(const std::string& path) {
  auto file = TensorFile::read(path, checkHead);
  if (!file) return file.error();
  return withRightSum(std::move(*file));
}

Result<std::shared_ptr<const TensorFile>> checkedQFile(TensorFile file) {
  if (const Status s = checkHead(file); !s) return s.error();
  return withRightSum(std::move(file));
}

namespace {

/// The file that a file began with, the file that this one began with, and so on: the last few of a long chain.
Json ancestors(const Json& began, int generations) {
  Json kept = began;
  if (!kept.is_object() || !kept.contains("began_with")) return kept;
  if (generations == 0)
    kept.erase("began_with");
  else
    kept["began_with"] = ancestors(began["began_with"], generations - 1);
  return kept;
}

}  // namespace

std::string wholeHashOf(const TensorFile& file) {
  Hash64 hash;
  add(hash, file.write());
  return fmt::format("{:016x}", hash.value());
}

std::string riskNote(const TensorFile& file, const Configuration& c) {
  const Parameters::Entry* learn = c.parameters.find("risk.learn");
  if (!learn || learn->value == 0.0 || partOf(file.about, "estimates").contains("risk")) return "";
  return fmt::format("{}: it knows nothing of the risk of a fall, which begins at {}.", file.name,
                     c.parameters.get("risk.initial"));
}

Json withoutFolders(Json began) {
  if (!began.is_object()) return began;
  for (auto& [key, value] : began.items()) {
    if (value.is_object()) value = withoutFolders(std::move(value));
    if (value.is_string() && (key == "file" || key == "resampled_from"))
      value = std::filesystem::path(value.get<std::string>()).filename().string();
  }
  return began;
}

void beginWith(Configuration& configuration, std::shared_ptr<const TensorFile> file) {
  configuration.beganWith = {{"file", file->name}, {"content", contentOf(*file)}};
  constexpr int kMostAncestors = 8;
  if (file->about.contains("learned")) configuration.beganWith["learned"] = file->about["learned"];
  if (file->about.contains("began_with"))
    configuration.beganWith["began_with"] = ancestors(file->about["began_with"], kMostAncestors);
  configuration.beganWith = withoutFolders(std::move(configuration.beganWith));
  configuration.start = std::move(file);
}

Result<Configuration> configurationOf(const Registry& registry, const TensorFile& file) {
  if (!file.about.contains("configuration")) return fileError(file.name, "it holds no configuration.");
  auto c = configurationFromJson(registry, file.about["configuration"], file.name);
  if (!c) return c.error();
  if (file.about.contains("seed") && file.about["seed"].is_number_unsigned())
    c->seed = file.about["seed"].get<std::uint64_t>();
  auto teacher = teacherIn(file);
  if (!teacher) return teacher.error();
  if (*teacher)
    c->teacher = std::move(*teacher);
  else if (file.about.value("kind", Json()) !=
           "checkpoint")  // a Q-function does not carry the one that acted as its guardian
    leaveTeacher(*c);
  return c;
}

std::string originOf(const TensorFile& file, const std::string& path) {
  const Json& about = file.about;
  return fmt::format("From {}, content {}, after {} steps and {} episodes with {} falls; Surefoot {}.",
                     std::filesystem::path(path).filename().string(), contentOf(file),
                     jsonText(about.value("/learned/steps"_json_pointer, Json(0))),
                     jsonText(about.value("/learned/episodes"_json_pointer, Json(0))),
                     jsonText(about.value("/learned/falls"_json_pointer, Json(0))),
                     about.value("program", "of an unknown version"));
}

}  // namespace surefoot
