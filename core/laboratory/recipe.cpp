// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/files/read_file.h"
#include "core/laboratory/plan_file.h"

namespace surefoot {

namespace {

using Json = nlohmann::json;

std::string take(Json& block, const char* key) {
  std::string text = block.contains(key) && block[key].is_string() ? block[key].get<std::string>() : "";
  block.erase(key);
  return text;
}

Status readFigures(const Json& blocks, Recipe& recipe) {
  for (Json block : blocks) {
    FigureSpec figure{.name = take(block, "name"),
                      .title = take(block, "title"),
                      .kind = take(block, "kind"),
                      .conditions = {},
                      .along = take(block, "along"),
                      .q = {},
                      .state = {}};
    if (const std::string measure = take(block, "measure"); !measure.empty()) figure.measure = measure;
    for (const Json& pattern : block.value("conditions", Json::array()))
      if (pattern.is_string()) figure.conditions.push_back(pattern);
    block.erase("conditions");
    for (auto& [key, numbers] :
         {std::pair<const char*, std::vector<double>&>{"q", figure.q}, {"state", figure.state}}) {
      for (const Json& number : block.value(key, Json::array()))
        if (number.is_number()) numbers.push_back(number);
      block.erase(key);
    }
    const bool nameFits = !figure.name.empty() && figure.name.find_first_of("/\\") == std::string::npos;
    if (!nameFits || !block.empty())
      return Error{fmt::format(
          "figure {}: {}.", figure.name,
          block.empty() ? "a name is needed, without a slash" : "there is no \"" + block.begin().key() + "\"")};
    recipe.figures.push_back(std::move(figure));
  }
  return Done{};
}

Status readClaims(const Json& blocks, Recipe& recipe) {
  std::set<std::string> ids;
  for (Json block : blocks) {
    Claim claim{.id = take(block, "id"), .kind = take(block, "kind"), .says = take(block, "says"), .arguments = {}};
    claim.calibrated = block.value("calibrated", Json(false)) == Json(true);
    block.erase("calibrated");
    claim.arguments = std::move(block);
    if (claim.id.empty() || !ids.insert(claim.id).second)
      return Error{fmt::format("claim {}: every claim needs an id of its own.", claim.id)};
    recipe.claims.push_back(std::move(claim));
  }
  return Done{};
}

/// All patterns that a claim names its conditions with.
std::vector<std::string> patternsOf(const Claim& claim) {
  std::vector<std::string> patterns;
  const auto add = [&](const auto& self, const Json& value) -> void {
    if (value.is_string()) patterns.push_back(value);
    if (value.is_array())
      for (const Json& element : value) self(self, element);
  };
  for (const char* key : {"conditions", "others", "pairs", "groups", "reference"})
    if (claim.arguments.contains(key)) add(add, claim.arguments[key]);
  for (const Json& row : claim.arguments.value("rows", Json::array()))
    for (const char* key : {"condition", "of"})
      if (row.is_object() && row.contains(key)) add(add, row[key]);
  return patterns;
}

}  // namespace

Result<Recipe> parseRecipe(const Registry& registry, const std::string& text, const std::string& path,
                           const PlanChanges& changes) {
  auto plan = parsePlan(registry, text, path, changes);
  if (!plan) return plan.error();
  const auto blocks = parseRecipeBlocks(text, path);
  if (!blocks) return blocks.error();
  Recipe recipe{.name = std::filesystem::path(path).stem().string(),
                .shows = {},
                .table = {},
                .plan = std::move(*plan),
                .figures = {},
                .claims = {}};
  for (const Json& shown : (*blocks)["shows"])
    if (shown.is_string()) recipe.shows.push_back(shown);
  const auto measures = measureNames();
  for (const Json& column : (*blocks)["table"]) {
    const std::string measure = column.is_string() ? column.get<std::string>() : column.dump();
    if (std::find(measures.begin(), measures.end(), measure) == measures.end())
      return planError(path, 0, fmt::format("table: there is no measure \"{}\".", measure));
    recipe.table.push_back(measure);
  }
  if (const Status s = readFigures((*blocks)["figure"], recipe); !s) return planError(path, 0, s.error().message);
  if (const Status s = readClaims((*blocks)["claim"], recipe); !s) return planError(path, 0, s.error().message);
  return recipe;
}

bool Recipe::calibrated() const {
  return std::any_of(claims.begin(), claims.end(), [](const Claim& c) { return c.calibrated; });
}

Result<std::vector<std::string>> recipeShows(const std::string& path) {
  const auto text = readText(path);
  if (!text) return text.error();
  const auto blocks = parseRecipeBlocks(*text, path);
  if (!blocks) return blocks.error();
  std::vector<std::string> shows;
  for (const Json& shown : (*blocks)["shows"])
    if (shown.is_string()) shows.push_back(shown);
  return shows;
}

Result<Recipe> readRecipe(const Registry& registry, const std::string& path, const PlanChanges& changes) {
  const auto text = readText(path);
  if (!text) return text.error();
  return parseRecipe(registry, *text, path, changes);
}

Result<Recipe> onLabPreset(const Registry& registry, const std::string& path, const PlanChanges& changes) {
  PlanChanges lab = changes;
  lab.preset = "lab";
  auto recipe = readRecipe(registry, path, lab);
  if (!recipe) return recipe;
  recipe->figures.clear();
  std::erase_if(recipe->claims, [](const Claim& c) { return !c.calibrated; });
  std::set<std::string> needed;
  auto& conditions = recipe->plan.conditions;
  for (const Claim& claim : recipe->claims)
    for (const std::string& pattern : patternsOf(claim))
      for (const Condition& c : conditions)
        if (fits(c.name, pattern)) needed.insert(c.name), needed.insert(c.reference);
  std::erase_if(conditions, [&](const Condition& c) { return !needed.contains(c.name); });
  return recipe;
}

}  // namespace surefoot
