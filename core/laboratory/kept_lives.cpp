// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/kept_lives.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <new>

#include "core/basics/typed_json.h"
#include "core/experiment/configuration_json.h"
#include "core/files/whole_file.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;
constexpr const char* kEnding = ".safetensors";

std::string hashOf(const std::string& text, std::uint64_t seed, int number) {
  Hash64 hash;
  hash.add(static_cast<std::uint64_t>(kLivesVersion));
  hash.add(std::string_view(text));
  hash.add(seed);
  hash.add(static_cast<std::uint64_t>(number));
  return fmt::format("{:016x}", hash.value());
}

/// Whether a file of the folder is one of ours.
bool isOurs(const fs::path& path) {
  const std::string name = path.filename().string();
  return (name.starts_with("life-") || name.starts_with("pre-learning-")) && name.ends_with(kEnding);
}

std::string folderOf(const std::string& storePath) {
  return storePath + ".lives";
}

}  // namespace

KeptLives::KeptLives(const std::string& storePath) : folder_(folderOf(storePath)) {}

std::string KeptLives::nameOf(const Condition& c, int life) {
  return "life-" + hashOf(c.text, c.configuration.seed, life);
}
std::string KeptLives::nameOf(const PreLearning& p, int qFunction) {
  auto json = configurationAsJson(p.configuration);
  json.erase("lives");
  return "pre-learning-" + hashOf(jsonText(json), p.configuration.seed, qFunction);
}

std::string KeptLives::fileOf(const std::string& name) const {
  return folder_ + "/" + name + kEnding;
}

bool KeptLives::has(const std::string& name) const {
  std::error_code ignored;
  return fs::is_regular_file(fileOf(name), ignored);
}

Status KeptLives::keep(const std::string& name, TensorFile content) {
  const std::lock_guard lock(mutex_);
  if (mkdir(folder_.c_str(), 0777) != 0 && errno != EEXIST)
    return fileError(folder_, "lives in hand cannot be kept: the folder cannot be made.");
  try {
    auto file = WholeFile::createOrReplace("a life in hand", fileOf(name));
    if (!file) return file.error();
    if (const Status s = file->append(content.head()); !s) return s;
    for (const Tensor& tensor : content.tensors)
      if (const Status s = file->append(tensor.bytes); !s) return s;
    return file->commit();
  } catch (const std::bad_alloc&) {
    return Error{"There is not enough memory to keep a life in hand."};
  }
}

std::shared_ptr<const TensorFile> KeptLives::read(const std::string& name) {
  auto file = readQFile(fileOf(name));
  if (file) return *file;
  drop(name);
  return nullptr;
}

void KeptLives::drop(const std::string& name) {
  unlink(fileOf(name).c_str());
  // This does nothing while something is in it. Who is about to write there has made the folder and needs it.
  if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) rmdir(folder_.c_str());
}

void KeptLives::keepOnly(const std::set<std::string>& names) {
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(folder_, failed))
    if (isOurs(entry.path()) && !names.contains(entry.path().stem().string())) unlink(entry.path().c_str());
  const std::lock_guard lock(mutex_);
  rmdir(folder_.c_str());
}

int KeptLives::count(const std::string& storePath) {
  std::error_code failed;
  int lives = 0;
  for (const auto& entry : fs::directory_iterator(folderOf(storePath), failed)) lives += isOurs(entry.path());
  return lives;
}

Json asJson(const StoredPreLearning& p) {
  return {{"q_function", p.qFunction},
          {"episodes", p.episodes},
          {"falls", p.falls},
          {"steps", p.steps},
          {"reached", p.reached},
          {"average_reward", p.averageReward},
          {"hash", fmt::format("{:016x}", p.hash)}};
}

std::optional<StoredPreLearning> preLearningFrom(const Json& json) {
  if (!json.is_object()) return std::nullopt;
  for (const char* key : {"q_function", "episodes", "falls", "steps"})
    if (!json.contains(key) || !json[key].is_number_integer()) return std::nullopt;
  if (!json.contains("average_reward") || !json["average_reward"].is_number() || !json.contains("reached") ||
      !json["reached"].is_boolean() || !json.contains("hash") || !json["hash"].is_string())
    return std::nullopt;
  StoredPreLearning p{.qFunction = json["q_function"].get<int>(),
                      .episodes = json["episodes"].get<std::int64_t>(),
                      .falls = json["falls"].get<std::int64_t>(),
                      .steps = json["steps"].get<std::int64_t>(),
                      .averageReward = json["average_reward"].get<double>(),
                      .reached = json["reached"].get<bool>()};
  const std::string& hash = json["hash"].get_ref<const std::string&>();
  const auto [end, code] = std::from_chars(hash.data(), hash.data() + hash.size(), p.hash, 16);
  if (code != std::errc{} || end != hash.data() + hash.size()) return std::nullopt;
  return p;
}

}  // namespace surefoot
