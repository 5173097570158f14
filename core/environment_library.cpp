// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files/read_file.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// Where a file lies, without symbolic links.
std::string folderOf(const std::string& file) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
  const std::filesystem::path real = std::filesystem::canonical(folder, error);
  return (error ? folder : real).string();
}

}  // namespace

using FileResult = Result<std::shared_ptr<const EnvironmentFile>>;

FileResult EnvironmentLibrary::open(const std::string& path) {
  const auto text = readText(path);
  if (!text) return Error{text.error().message, ErrorKind::File};
  return keep(*text, path, path, path);
}

FileResult EnvironmentLibrary::add(std::string_view text, const std::string& file, const std::string& path) {
  return keep(text, file, "", isTheSame(text, path) ? path : file);
}

bool EnvironmentLibrary::isTheSame(std::string_view text, const std::string& path) const {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  const auto there = readText(path);
  if (!there) return false;
  std::vector<Complaint> complaints;
  const std::string folder = folderOf(path);
  const auto one = reader_(text, folder, complaints), other = reader_(*there, folder, complaints);
  return one && other && one->entry.name == other->entry.name;
}

FileResult EnvironmentLibrary::keep(std::string_view text, const std::string& file, const std::string& path,
                                    const std::string& beside) {
  const std::lock_guard lock(mutex_);
  for (const auto& [name, known] : files_)
    if (known->text == text && known->starts.empty() && (path.empty() || known->path == path)) return known;
  std::vector<Complaint> complaints;
  const std::string folder = folderOf(beside);
  auto made = reader_(text, folder, complaints);
  if (!made) {
    std::string first = complaintLine(file, complaints.front());
    if (complaints.size() > 1) first += fmt::format(" There are more: surefoot check {}", file);
    return Error{first, ErrorKind::File};
  }
  made->path = path;
  made->home = (std::filesystem::path(folder) / std::filesystem::path(beside).filename()).string();
  auto kept = std::make_shared<const EnvironmentFile>(std::move(*made));
  // Another text that says the same (other comments) is the same environment: the first stays. But the program of a
  // robot may be another in another folder, through what lies there: the newest is the one that is meant.
  auto& place = files_[kept->entry.name];
  if (place && place->program == kept->program) return place;
  if (place) before_.push_back(place);
  return place = kept;
}

std::shared_ptr<const EnvironmentFile> EnvironmentLibrary::find(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : found->second;
}

std::vector<std::string> EnvironmentLibrary::shelved() const {
  std::vector<std::string> names;
  std::error_code error;
  if (!shelf_.empty())
    for (const auto& entry : std::filesystem::directory_iterator(shelf_, error))
      if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string EnvironmentLibrary::shelvedPath(std::string_view name) const {
  const auto names = shelved();
  if (std::find(names.begin(), names.end(), name) == names.end()) return "";
  return (std::filesystem::path(shelf_) / (std::string(name) + ".toml")).string();
}

bool isEnvironmentPath(std::string_view name) {
  return name.ends_with(".toml") || name.find('/') != std::string_view::npos;
}

Status checkEnding(std::string_view option, const std::string& name) {
  std::error_code error;
  const bool forgotten = !name.ends_with(".toml") && !std::filesystem::exists(name, error) &&
                         std::filesystem::is_regular_file(name + ".toml", error);
  if (!forgotten) return Done{};
  return Error{fmt::format("{0}: there is no {1}, but a file {1}.toml.", option, printable(shortened(name))),
               ErrorKind::File};
}

std::string environmentBeside(const std::string& file, const std::string& name) {
  const std::filesystem::path path(name);
  if (!isEnvironmentPath(name) || path.is_absolute()) return name;
  return (std::filesystem::path(file).parent_path() / path).string();
}

std::string_view plainName(std::string_view environment) {
  return environment.substr(0, environment.find('@'));
}

Result<std::string> environmentNamed(const Registry& registry, const std::string& name) {
  const auto& compiled = registry.environments;
  if (!registry.files || std::any_of(compiled.begin(), compiled.end(), [&](const auto& e) { return e.name == name; }))
    return name;
  const std::string shelved = isEnvironmentPath(name) ? "" : registry.files->shelvedPath(name);
  if (const Status s = shelved.empty() ? checkEnding("environment", name) : Status(Done{}); !s) return s.error();
  if (shelved.empty() && !isEnvironmentPath(name)) return name;
  const auto file = registry.files->open(shelved.empty() ? name : shelved);
  if (!file) return file.error();
  return (*file)->entry.name;
}

Result<const EnvironmentEntry*> findEnvironment(const Registry& registry, std::string_view name) {
  if (registry.files)
    if (const auto file = registry.files->find(name)) return &file->entry;
  std::vector<std::string> names = registry.files ? registry.files->shelved() : std::vector<std::string>();
  for (const EnvironmentEntry& entry : registry.environments) {
    if (entry.name == name) return &entry;
    names.push_back(entry.name);
  }
  return Error{unknownName("environment", name, names).message};
}

namespace {

std::vector<const AssignmentEntry*> entriesOf(const std::vector<AssignmentEntry>& all, std::string_view environment) {
  std::vector<const AssignmentEntry*> own;
  for (const AssignmentEntry& entry : all)
    if (entry.environment == environment) own.push_back(&entry);
  return own;
}

Result<const AssignmentEntry*> findAmong(const std::vector<const AssignmentEntry*>& own,
                                         const std::vector<AssignmentEntry>& all, std::string_view what,
                                         std::string_view environment, std::string_view name) {
  std::vector<std::string> names;
  for (const AssignmentEntry* entry : own) {
    if (entry->name == name) return entry;
    names.push_back(entry->name);
  }
  for (const AssignmentEntry& entry : all)
    if (entry.name == name)
      return Error{fmt::format("{}: \"{}\" belongs to the environment {}, not to {}.", what, name, entry.environment,
                               environment)};
  if (names.empty()) return Error{fmt::format("{}: the environment {} has none.", what, environment)};
  return unknownName(what, name, names);
}

}  // namespace

std::vector<const AssignmentEntry*> presetsOf(const Registry& registry, std::string_view environment) {
  if (registry.files)
    if (const auto file = registry.files->find(environment)) return entriesOf(file->presets, environment);
  return entriesOf(registry.presets, environment);
}

std::vector<const AssignmentEntry*> scenariosOf(const Registry& registry, std::string_view environment) {
  if (registry.files)
    if (const auto file = registry.files->find(environment)) return entriesOf(file->scenarios, environment);
  return entriesOf(registry.scenarios, environment);
}

Result<const AssignmentEntry*> findPreset(const Registry& registry, std::string_view environment,
                                          std::string_view name) {
  return findAmong(presetsOf(registry, environment), registry.presets, "preset", environment, name);
}

Result<const AssignmentEntry*> findScenario(const Registry& registry, std::string_view environment,
                                            std::string_view name) {
  return findAmong(scenariosOf(registry, environment), registry.scenarios, "scenario", environment, name);
}

}  // namespace surefoot
