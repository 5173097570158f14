// SPDX-License-Identifier: GPL-3.0-or-later
// Which programs environments may start. A robot without a program is data; one with a program runs what it names, so
// somebody has to say so first. Any thread.
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace surefoot {

class EnvironmentPrograms {
 public:
  /// `program`: EnvironmentFile::program, which changes with the command, its folder and its files.
  void allow(std::string_view program);
  void allowAll();
  bool isAllowed(std::string_view program) const;

  /// The folder of the modules that come with Surefoot, for programs in Python.
  void setModules(std::string folder);
  std::string modules() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string, std::less<>> allowed_;
  bool all_ = false;
  std::string modules_;
};

}  // namespace surefoot
