// SPDX-License-Identifier: GPL-3.0-or-later
// Which programs environments may start. A robot without a program is data; one with a program runs what it names, so
// somebody has to say so first. Any thread.
#pragma once

#include <atomic>
#include <functional>
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

  /// Whoever waits for a program stops waiting when `flag`, which may be set by anyone, is; or with stopWaiting().
  void stopWaitingWith(const std::atomic<bool>* flag) { flag_ = flag; }
  void stopWaiting() { stopped_ = true; }
  bool isStopped() const;

  /// Where a sentence goes that a person should see: a program starts without a cage. Said once.
  void setRemark(std::function<void(const std::string&)> remark);
  void remark(const std::string& sentence) const;

  /// The folder of the modules that come with Surefoot, for programs in Python.
  void setModules(std::string folder);
  std::string modules() const;

 private:
  mutable std::mutex mutex_;
  std::set<std::string, std::less<>> allowed_;
  bool all_ = false;
  const std::atomic<bool>* flag_ = nullptr;
  std::atomic<bool> stopped_{false};
  std::function<void(const std::string&)> remark_;
  mutable std::set<std::string> said_;
  std::string modules_;
};

}  // namespace surefoot
