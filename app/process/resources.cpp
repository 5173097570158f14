// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/process/resources.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "core/files/read_file.h"
#include "core/parameters.h"
#include "core/plans/plan_file.h"
#include "core/plans/plan_time.h"
#include "core/recipes/recipe.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace fs = std::filesystem;

std::string resourceFolder(const std::string& name) {
  std::error_code error;
  std::vector<fs::path> places = {fs::read_symlink("/proc/self/exe", error).parent_path()};
  Dl_info library{};  // where this code lies, if not in the program
  if (dladdr(reinterpret_cast<const void*>(&resourceFolder), &library) != 0 && library.dli_fname)
    places.insert(places.begin(), fs::canonical(library.dli_fname, error).parent_path());
  for (const fs::path& here : places)
    for (const char* way : {"resources", "../share/surefoot", "../../share/surefoot"})
      if (const fs::path folder = here / way / name; fs::is_directory(folder, error))
        return folder.lexically_normal().string();
  return "";
}

namespace {

/// The TOML files of a folder of resources and of the folders in it, in order: "4.10" behind "4.9".
std::vector<fs::path> filesIn(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(resourceFolder(folder), error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  const auto key = [](const fs::path& file) {
    std::string name = file.stem().string(), padded;
    for (std::size_t i = 0; i < name.size();) {
      std::size_t digits = 0;
      while (i + digits < name.size() && std::isdigit(static_cast<unsigned char>(name[i + digits]))) ++digits;
      if (digits == 0) {
        padded += name[i++];
        continue;
      }
      padded += std::string(digits < 4 ? 4 - digits : 0, '0') + name.substr(i, digits);
      i += digits;
    }
    return padded;
  };
  std::sort(files.begin(), files.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  return files;
}

}  // namespace

std::vector<std::string> shippedPlans() {
  std::vector<std::string> names;
  for (const fs::path& file : filesIn("plans")) names.push_back(file.stem().string());
  return names;
}

Result<std::string> findPlan(const std::string& plan) {
  std::error_code error;
  if (plan.find('/') != std::string::npos || plan.ends_with(".toml") || fs::is_regular_file(plan, error)) return plan;
  const auto names = shippedPlans();
  if (std::find(names.begin(), names.end(), plan) != names.end())
    return (fs::path(resourceFolder("plans")) / (plan + ".toml")).string();
  const std::string near = nearestWord(plan, names);
  if (names.empty())
    return Error{
        fmt::format("PLAN: there is no file called \"{}\", and the plans that come with the program are missing.",
                    shortened(plan)),
        ErrorKind::File};
  return Error{fmt::format("PLAN: there is no file and no plan called \"{}\"{}; the plans are {}.", shortened(plan),
                           near.empty() ? "" : ", did you mean " + near, joinWords(names)),
               ErrorKind::File};
}

std::vector<std::string> shippedRecipes() {
  std::vector<std::string> names;
  for (const fs::path& file : filesIn("recipes")) names.push_back(file.stem().string());
  return names;
}

Result<std::vector<std::string>> findRecipes(const std::vector<std::string>& wanted) {
  const auto files = filesIn("recipes");
  std::vector<std::string> known = {"all"};
  std::vector<std::vector<std::string>> names;  // the names that each file can be asked for by
  for (const fs::path& file : files) {
    const auto head = recipeHead(file.string());
    if (!head) return head.error();
    names.push_back({file.stem().string()});
    names.back().insert(names.back().end(), head->shows.begin(), head->shows.end());
    known.insert(known.end(), names.back().begin(), names.back().end());
    if (!head->apart) names.back().push_back("all");
  }
  std::vector<bool> chosen(files.size());
  std::vector<std::string> paths;
  for (const std::string& want : wanted) {
    if (want.ends_with(".toml")) {
      paths.push_back(want);
      continue;
    }
    bool found = false;
    for (std::size_t i = 0; i < files.size(); ++i)
      if (std::find(names[i].begin(), names[i].end(), want) != names[i].end()) found = chosen[i] = true;
    if (found) continue;
    const std::string near = nearestWord(want, known);
    return Error{fmt::format("LIST: there is no recipe for \"{}\"{}; all runs every one that does not take long.",
                             shortened(want), near.empty() ? "" : ", did you mean " + near)};
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    if (chosen[i]) paths.push_back(files[i].string());
  return paths;
}

std::vector<ShippedPlan> allShipped(const Registry& registry) {
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<ShippedPlan> all;
  for (const bool recipe : {false, true})
    for (const fs::path& file : filesIn(recipe ? "recipes" : "plans")) {
      ShippedPlan plan{.name = file.stem().string(), .title = {}, .path = file.string(), .recipe = recipe};
      const auto text = readText(plan.path);
      const auto parsed = text ? parsePlanFile(*text, plan.path) : Result<PlanFile>(text.error());
      if (parsed) {
        plan.shows = parsed->shows;
        plan.answers = parsed->answers;
        plan.minutes = minutesFor(registry, *parsed, threads);
      }
      if (parsed)
        for (const PlanSetting& setting : parsed->head)
          if (setting.key == "title" && !setting.values.empty()) plan.title = setting.values[0];
      all.push_back(std::move(plan));
    }
  return all;
}

}  // namespace surefoot
