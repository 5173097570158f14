// SPDX-License-Identifier: GPL-3.0-or-later
// Environments that come from files of their own (a robot), beside those that are compiled in. Each is kept under a
// name made of its own and a hash of what it says, "hopper@3f2a91c0", so that two files of one name are two
// environments, and a text that travels in another file is the same environment wherever it is read.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/environment_inspection.h"
#include "core/registry.h"

namespace surefoot {

/// An environment with its presets and scenarios, and the text it was made from.
struct EnvironmentFile {
  EnvironmentEntry entry;
  std::vector<AssignmentEntry> presets{}, scenarios{};
  std::string text{};
  std::string path{};     ///< where it was read; empty: it came inside another file
  std::string home{};     ///< the file beside which its program lies; with its folders
  std::string starts{};   ///< the command of a program that moves it, "python3 hopper.py"; empty: it is data
  std::string program{};  ///< the program for EnvironmentPrograms: command, folder and what its files hold
  /// The same robot left to itself, without motors, dampers, friction and contacts, if it hangs on the world; or as it
  /// is drawn, a little above the ground, if it does not. Null: it cannot be.
  std::function<std::unique_ptr<Environment>()> passive{}, dropped{};
  /// Lets it move at random and tells what came of it; takes some tenths of a second.
  std::function<EnvironmentInspection()> inspect{};
};

/// Any thread. What was added stays: entries can be pointed to as long as the library lives.
class EnvironmentLibrary {
 public:
  /// Makes an environment from a text; nothing, with all complaints in the order of the text: something is wrong. A
  /// program that moves it is looked for in `folder`.
  using Reader = std::function<std::optional<EnvironmentFile>(std::string_view text, const std::string& folder,
                                                              std::vector<Complaint>& complaints)>;

  explicit EnvironmentLibrary(Reader reader) : reader_(std::move(reader)) {}

  /// Reads a file, or a text that came in `file`; known texts are read only once. `path`: where the text was read
  /// first; if this robot still lies there, its program is looked for there, else beside `file`.
  Result<std::shared_ptr<const EnvironmentFile>> open(const std::string& path);
  Result<std::shared_ptr<const EnvironmentFile>> add(std::string_view text, const std::string& file,
                                                     const std::string& path = "");
  /// Reads a text that is still being written: nothing is kept of it.
  std::optional<EnvironmentFile> read(std::string_view text, const std::string& folder,
                                      std::vector<Complaint>& complaints) const {
    return reader_(text, folder, complaints);
  }
  /// The folder of the files that come with the program: they are known by their file's names, and read when they are
  /// asked for.
  void setShelf(std::string folder) { shelf_ = std::move(folder); }
  const std::string& shelf() const { return shelf_; }
  /// Their names, in order.
  std::vector<std::string> shelved() const;
  /// The path of one of them; empty: there is none of this name.
  std::string shelvedPath(std::string_view name) const;

  /// By its name; null: there is none.
  std::shared_ptr<const EnvironmentFile> find(std::string_view name) const;

 private:
  Result<std::shared_ptr<const EnvironmentFile>> keep(std::string_view text, const std::string& file,
                                                      const std::string& path, const std::string& beside);
  bool isTheSame(std::string_view text, const std::string& path) const;

  Reader reader_;
  std::string shelf_;
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const EnvironmentFile>, std::less<>> files_;
  std::vector<std::shared_ptr<const EnvironmentFile>> before_;  ///< others have taken their names
};

/// Whether a person means a file: "hopper.toml", "robots/hopper.toml".
bool isEnvironmentPath(std::string_view name);

/// Refuses the name of a file without its ending, "hopper" where there is a hopper.toml.
Status checkEnding(std::string_view option, const std::string& name);

/// The file of a robot that a file names: beside that one, if its path does not begin at the root. A name stays.
std::string environmentBeside(const std::string& file, const std::string& name);

/// "hopper" of "hopper@3f2a91c0": what two versions of a robot have in common.
std::string_view plainName(std::string_view environment);

/// The name of an environment: as it is, or of the robot in the file that it names, or that comes with the program.
Result<std::string> environmentNamed(const Registry& registry, const std::string& name);

/// By its name, compiled in or from a file that was opened.
Result<const EnvironmentEntry*> findEnvironment(const Registry& registry, std::string_view name);

/// What belongs to an environment, in its order: the first is the usual one.
std::vector<const AssignmentEntry*> presetsOf(const Registry& registry, std::string_view environment);
std::vector<const AssignmentEntry*> scenariosOf(const Registry& registry, std::string_view environment);

/// One of these by its name; the error says what there is, or to which other environment the name belongs.
Result<const AssignmentEntry*> findPreset(const Registry& registry, std::string_view environment,
                                          std::string_view name);
Result<const AssignmentEntry*> findScenario(const Registry& registry, std::string_view environment,
                                            std::string_view name);

}  // namespace surefoot
