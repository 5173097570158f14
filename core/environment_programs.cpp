// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/environment_programs.h"

namespace surefoot {

void EnvironmentPrograms::allow(std::string_view program) {
  const std::lock_guard lock(mutex_);
  allowed_.emplace(program);
}

void EnvironmentPrograms::allowAll() {
  const std::lock_guard lock(mutex_);
  all_ = true;
}

bool EnvironmentPrograms::isAllowed(std::string_view program) const {
  const std::lock_guard lock(mutex_);
  return all_ || allowed_.contains(program);
}

bool EnvironmentPrograms::isStopped() const {
  return stopped_ || (flag_ && *flag_);
}

void EnvironmentPrograms::setRemark(std::function<void(const std::string&)> remark) {
  const std::lock_guard lock(mutex_);
  remark_ = std::move(remark);
}

void EnvironmentPrograms::remark(const std::string& sentence) const {
  const std::lock_guard lock(mutex_);
  if (remark_ && said_.insert(sentence).second) remark_(sentence);
}

void EnvironmentPrograms::setModules(std::string folder) {
  const std::lock_guard lock(mutex_);
  modules_ = std::move(folder);
}

std::string EnvironmentPrograms::modules() const {
  const std::lock_guard lock(mutex_);
  return modules_;
}

}  // namespace surefoot
