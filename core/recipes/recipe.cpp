// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "core/basics/typed_json.h"
#include "core/files/read_file.h"
#include "core/plans/plan_file.h"
#include "core/plans/plan_systems.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

using Json = nlohmann::json;

/// The type of an argument of a figure or a claim.
enum class Takes { Text, Number, Flag, Texts, Numbers, ListsOfTexts, Tables, TextOrNumber };

const char* wordsFor(Takes takes) {
  constexpr const char* kWords[] = {"a text",           "a number",          "true or false",
                                    "a list of texts",  "a list of numbers", "a list of lists of texts",
                                    "a list of tables", "a number or a text"};
  return kWords[static_cast<int>(takes)];
}

bool isOne(const Json& value, Takes takes) {
  const auto all = [&](Takes each) {
    return value.is_array() && std::all_of(value.begin(), value.end(), [&](const Json& v) { return isOne(v, each); });
  };
  switch (takes) {
    case Takes::Text:
      return value.is_string();
    case Takes::Number:
      return value.is_number();
    case Takes::Flag:
      return value.is_boolean();
    case Takes::Texts:
      return all(Takes::Text);
    case Takes::Numbers:
      return all(Takes::Number);
    case Takes::ListsOfTexts:
      return all(Takes::Texts);
    case Takes::Tables:
      return value.is_array() && std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_object(); });
    case Takes::TextOrNumber:
      return value.is_string() || value.is_number();
  }
  return false;
}

using Keys = std::map<std::string, Takes>;

/// Checks that every key is known and has a value of its type. Later code takes the values without checks.
Status checkKeys(const Json& block, const Keys& keys) {
  for (const auto& [key, value] : block.items()) {
    const auto known = keys.find(key);
    if (known == keys.end()) {
      std::vector<std::string> names;
      for (const auto& [name, takes] : keys) names.push_back(name);
      return unknownKey(key, names);
    }
    if (!isOne(value, known->second))
      return Error{
          fmt::format("{}: {} is expected, not {}.", key, wordsFor(known->second), shortened(jsonText(value)))};
  }
  return Done{};
}

Error wrong(const char* what, const std::string& name, const std::string& sentence) {
  return Error{fmt::format("{} {}: {}", what, shortened(name), sentence)};
}

/// Returns the text of `key` and removes it from the block.
std::string take(Json& block, const char* key) {
  std::string text = textIn(block, key);
  block.erase(key);
  return text;
}

/// All patterns by which a claim names its conditions.
std::vector<std::string> patternsOf(const Claim& claim) {
  std::vector<std::string> patterns;
  const auto add = [&](const auto& self, const Json& value) -> void {
    if (value.is_string()) patterns.push_back(value);
    if (value.is_array())
      for (const Json& element : value) self(self, element);
  };
  for (const char* key : {"conditions", "lab_conditions", "others", "pairs", "groups", "reference", "by"})
    if (claim.arguments.contains(key)) add(add, claim.arguments[key]);
  for (const Json& row : partOf(claim.arguments, "rows"))
    for (const char* key : {"condition", "of"})
      if (row.is_object() && row.contains(key)) add(add, row[key]);
  return patterns;
}

/// The conditions that a figure or a claim names must exist: checked before any life is lived for it.
Status checkNamed(const Recipe& recipe, const std::vector<std::string>& patterns) {
  for (const std::string& pattern : patterns)
    if (std::none_of(recipe.plan.conditions.begin(), recipe.plan.conditions.end(), [&](const Condition& c) {
          return fits(c.name, pattern) || fits(systemOf(c.name).second, pattern);
        }))
      return Error{fmt::format("conditions: none is called \"{}\".", shortened(pattern))};
  return Done{};
}

std::set<std::string> environmentsOf(const Plan& plan) {
  std::set<std::string> names;
  for (const Condition& c : plan.conditions) names.insert(c.configuration.names.environment);
  return names;
}

Status checkMeasures(const Json& arguments, const std::vector<std::string>& measures) {
  for (const char* key : {"measure", "other"})
    if (arguments.contains(key) && std::find(measures.begin(), measures.end(), arguments[key]) == measures.end())
      return Error{
          fmt::format("{}: there is no {}; it takes {}.", key, jsonText(arguments[key]), joinWords(measures, "or"))};
  return Done{};
}

Status readFigures(const Json& blocks, const std::vector<std::string>& measures, Recipe& recipe) {
  static const Keys kKeys = {{"name", Takes::Text},        {"title", Takes::Text},   {"kind", Takes::Text},
                             {"conditions", Takes::Texts}, {"measure", Takes::Text}, {"along", Takes::Text},
                             {"q", Takes::Numbers},        {"state", Takes::Numbers}};
  std::set<std::string> names;
  for (const Json& block : blocks) {
    FigureSpec figure{.name = textIn(block, "name"),
                      .title = textIn(block, "title"),
                      .kind = textIn(block, "kind"),
                      .conditions = {},
                      .measure = textIn(block, "measure", "falls"),
                      .along = textIn(block, "along"),
                      .q = {},
                      .state = {}};
    if (const Status s = checkKeys(block, kKeys); !s) return wrong("figure", figure.name, s.error().message);
    for (const Json& pattern : partOf(block, "conditions")) figure.conditions.push_back(pattern);
    for (const Json& number : partOf(block, "q")) figure.q.push_back(number);
    for (const Json& number : partOf(block, "state")) figure.state.push_back(number);
    if (figure.name.empty() || figure.name.find_first_of("/\\") != std::string::npos)
      return wrong("figure", figure.name, "a name is needed, without a slash.");
    if (const Status s = checkFigure(figure, measures); !s) return s;
    if (const Status s = checkNamed(recipe, figure.conditions); !s)
      return wrong("figure", figure.name, s.error().message);
    if (!names.insert(figure.name).second)
      return wrong("figure", figure.name, "there are two of this name; every figure needs one of its own.");
    recipe.figures.push_back(std::move(figure));
  }
  return Done{};
}

Status readCounts(Json& block, Claim& claim) {
  static const std::set<std::string> kExact = {"rule", "parameters", "drawn", "same-values"};
  claim.counts = claim.calibrated ? "fitted" : kExact.contains(claim.kind) ? "arithmetic" : "test";
  if (const std::string said = take(block, "counts"); !said.empty()) claim.counts = said;
  static const std::vector<std::string> kAll = {"test", "fitted", "arithmetic", "implied", "question"};
  if (std::find(kAll.begin(), kAll.end(), claim.counts) != kAll.end()) return Done{};
  return Error{fmt::format("counts: it takes {}.", joinWords(kAll, "or"))};
}

Status readClaims(const Json& blocks, const std::vector<std::string>& measures, Recipe& recipe) {
  static const Keys kKeys = {{"id", Takes::Text},
                             {"kind", Takes::Text},
                             {"says", Takes::Text},
                             {"calibrated", Takes::Flag},
                             {"thesis", Takes::TextOrNumber},
                             {"conditions", Takes::Texts},
                             {"others", Takes::Texts},
                             {"reference", Takes::Text},
                             {"measure", Takes::Text},
                             {"other", Takes::Text},
                             {"along", Takes::Text},
                             {"relation", Takes::Text},
                             {"relative", Takes::Flag},
                             {"counts", Takes::Text},
                             {"lab_conditions", Takes::Texts},
                             {"lab_says", Takes::Text},
                             {"draws", Takes::Text},
                             {"alongs", Takes::Texts},
                             {"by", Takes::Texts},
                             {"choose", Takes::Text},
                             {"of", Takes::Number},
                             {"within", Takes::Number},
                             {"tolerance", Takes::Number},
                             {"at_least", Takes::Number},
                             {"sign", Takes::Number},
                             {"low", Takes::Number},
                             {"high", Takes::Number},
                             {"thesis_lives", Takes::Number},
                             {"thesis_p", Takes::Number},
                             {"widest", Takes::Number},
                             {"first", Takes::Number},
                             {"steps", Takes::Number},
                             {"q", Takes::Numbers},
                             {"state", Takes::Numbers},
                             {"pairs", Takes::ListsOfTexts},
                             {"groups", Takes::ListsOfTexts},
                             {"rows", Takes::Tables}};
  std::set<std::string> ids;
  for (Json block : blocks) {
    const std::string id = textIn(block, "id");
    if (const Status s = checkKeys(block, kKeys); !s) return wrong("claim", id, s.error().message);
    if (id.empty() || !ids.insert(id).second) return wrong("claim", id, "every claim needs an id of its own.");
    Claim claim{.id = take(block, "id"), .kind = take(block, "kind"), .says = take(block, "says"), .arguments = {}};
    claim.calibrated = block.contains("calibrated") && block["calibrated"] == true;
    block.erase("calibrated");
    if (const Status s = readCounts(block, claim); !s) return wrong("claim", id, s.error().message);
    claim.arguments = std::move(block);
    if (const Status s = checkKind(claim); !s) return s;
    for (const Status& s : {checkMeasures(claim.arguments, measures), checkNamed(recipe, patternsOf(claim))})
      if (!s) return wrong("claim", id, s.error().message);
    recipe.claims.push_back(std::move(claim));
  }
  return Done{};
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
  const auto measures = measureNames(taskMeasuresOf(registry, environmentsOf(recipe.plan)));
  for (const Json& column : (*blocks)["table"]) {
    const std::string measure = column.is_string() ? column.get<std::string>() : jsonText(column);
    if (std::find(measures.begin(), measures.end(), measure) == measures.end())
      return planError(path, 0, fmt::format("table: there is no measure \"{}\".", measure));
    recipe.table.push_back(measure);
  }
  if (const Status s = readFigures((*blocks)["figure"], measures, recipe); !s)
    return planError(path, 0, s.error().message);
  if (const Status s = readClaims((*blocks)["claim"], measures, recipe); !s)
    return planError(path, 0, s.error().message);
  return recipe;
}

bool Recipe::calibrated() const {
  return std::any_of(claims.begin(), claims.end(), [](const Claim& c) { return c.calibrated; });
}

Result<RecipeHead> recipeHead(const std::string& path) {
  const auto text = readText(path);
  if (!text) return text.error();
  const auto blocks = parseRecipeBlocks(*text, path);
  if (!blocks) return blocks.error();
  RecipeHead head;
  head.apart = (*blocks)["apart"] == true;
  for (const Json& shown : (*blocks)["shows"])
    if (shown.is_string()) head.shows.push_back(shown);
  return head;
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
  for (Claim& claim : recipe->claims) {
    if (claim.counts == "fitted") claim.counts = "test";  // nothing was fitted to this preset
    const auto own = claim.arguments.find("lab_conditions");
    if (own != claim.arguments.end()) claim.arguments["conditions"] = *own;
    if (const auto says = claim.arguments.find("lab_says"); says != claim.arguments.end()) claim.says = *says;
  }
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
