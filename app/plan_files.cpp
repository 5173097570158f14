// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/plan_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/parameters.h"
#include "core/text.h"

namespace surefoot {

namespace fs = std::filesystem;

std::string resourceFolder(const std::string& name) {
  std::error_code error;
  const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& folder : {here / "resources" / name, here / ".." / "share" / "surefoot" / name})
    if (fs::is_directory(folder, error)) return folder.lexically_normal().string();
  return "";
}

std::vector<std::string> shippedPlans() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(resourceFolder("plans"), error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<std::string> findPlan(const std::string& plan) {
  std::error_code error;
  if (plan.find('/') != std::string::npos || plan.ends_with(".toml") || fs::is_regular_file(plan, error)) return plan;
  const auto names = shippedPlans();
  if (std::find(names.begin(), names.end(), plan) != names.end())
    return (fs::path(resourceFolder("plans")) / (plan + ".toml")).string();
  const std::string near = nearestWord(plan, names);
  return Error{fmt::format("PLAN: there is no file and no plan called \"{}\"{}; the plans are {}.", shortened(plan),
                           near.empty() ? "" : ", did you mean " + near, joinWords(names)),
               ErrorKind::File};
}

}  // namespace surefoot
