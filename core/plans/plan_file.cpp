// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "core/files/toml_parser.h"
#include "core/parameters.h"
#include "core/text/number_text.h"
#include "core/text/text.h"
#include "core/text/words.h"

namespace surefoot {

Error planError(const std::string& path, int line, const std::string& sentence) {
  const std::string where = line > 0 ? fmt::format(", line {}", line) : "";
  return Error{fmt::format("{}{}: {}", std::filesystem::path(path).filename().string(), where, sentence),
               ErrorKind::Usage};
}

namespace {

constexpr std::size_t kMostValues = 10'000;
constexpr int kDeepest = 8;

int lineOf(const toml::node& node) {
  return static_cast<int>(node.source().begin.line);
}

std::optional<std::string> valueAsText(const toml::node& node) {
  if (const auto* s = node.as_string()) return s->get();
  if (const auto* i = node.as_integer()) return fmt::format("{}", i->get());
  if (const auto* f = node.as_floating_point()) return fmt::format("{}", f->get());
  if (const auto* b = node.as_boolean()) return b->get() ? "true" : "false";
  return std::nullopt;
}

/// Whether a key belongs to the recipe and not to its plan.
bool isOfRecipes(const std::string& key) {
  for (const char* other :
       {"figure", "claim", "shows", "table", "answers", "apart", "minutes_on_two_cores", "minutes_for_lives"})
    if (key == other) return true;
  return false;
}

class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path) {}

  Result<PlanFile> read(const toml::table& root) {
    PlanFile file;
    std::vector<PlanSetting> shared;
    for (const auto& [key, node] : root) {
      const std::string name(key.str());
      if (name == "condition" || isOfRecipes(name)) continue;
      const std::map<std::string, std::vector<PlanSetting>*> tables = {{"base", &shared},
                                                                       {"pre-learning", &shared},
                                                                       {"systems", &file.systems},
                                                                       {"decided", &file.decided},
                                                                       {"search", &file.search}};
      const auto table = tables.find(name);
      const bool named = table == tables.end() || name == "pre-learning";  // its keys begin with its name
      const std::string prefix = named ? name + "." : "";
      auto& into = table == tables.end() ? file.head : *table->second;
      const Status s = node.is_table() ? flatten(*node.as_table(), prefix, into, 0) : add(name, node, into);
      if (!s) return s.error();
    }
    inOrder(file.head);
    inOrder(shared);
    for (auto* table : {&file.systems, &file.decided, &file.search}) inOrder(*table);

    const toml::node* conditions = root.get("condition");
    if (!conditions) return planError(path_, 0, "there is no [[condition]]; a plan needs at least one.");
    const toml::array* list = conditions->as_array();
    if (!list || list->empty() || !list->is_homogeneous<toml::table>())
      return planError(path_, lineOf(*conditions), "condition: write [[condition]] above each of them.");
    for (const toml::node& node : *list) {
      PlanBlock block{.settings = {}, .line = lineOf(node)};
      if (const Status s = flatten(*node.as_table(), "", block.settings, 0); !s) return s.error();
      inOrder(block.settings);
      addShared(shared, block.settings);
      file.blocks.push_back(std::move(block));
    }
    readRecipe(root, file);
    return file;
  }

 private:
  static void readRecipe(const toml::table& root, PlanFile& file) {
    file.answers = root["answers"].value_or(std::string());
    file.minutesOnTwoCores = root["minutes_on_two_cores"].value_or(0.0);
    file.minutesForLives = root["minutes_for_lives"].value_or(0.0);
    if (const toml::array* shows = root["shows"].as_array())
      for (const toml::node& shown : *shows)
        if (const auto* text = shown.as_string()) file.shows.push_back(text->get());
  }

  Status flatten(const toml::table& table, const std::string& prefix, std::vector<PlanSetting>& into, int depth) {
    if (depth > kDeepest) return planError(path_, lineOf(table), prefix + ": tables are nested too deeply.");
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      const Status s = node.is_table() ? flatten(*node.as_table(), name + ".", into, depth + 1) : add(name, node, into);
      if (!s) return s;
    }
    return Done{};
  }

  Status add(const std::string& key, const toml::node& node, std::vector<PlanSetting>& into) {
    PlanSetting setting{.key = key, .values = {}, .line = lineOf(node)};
    if (const toml::array* list = node.as_array()) {
      if (list->empty() || list->size() > kMostValues)
        return planError(path_, setting.line, fmt::format("{}: a list has 1 to {} values.", key, kMostValues));
      for (const toml::node& element : *list) {
        auto text = valueAsText(element);
        if (!text) return refuse(key, setting.line);
        if (std::find(setting.values.begin(), setting.values.end(), *text) != setting.values.end())
          return planError(path_, setting.line, fmt::format("{}: {} is listed twice.", key, shortened(*text)));
        setting.values.push_back(std::move(*text));
      }
    } else if (auto text = valueAsText(node)) {
      setting.values.push_back(std::move(*text));
    } else {
      return refuse(key, setting.line);
    }
    for (const std::string& value : setting.values) {
      if (value.empty() && key != "name")
        return planError(path_, setting.line, fmt::format("{}: it is empty; leave it away, or give a value.", key));
      if (std::any_of(value.begin(), value.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
        return planError(path_, setting.line,
                         fmt::format("{}: a text holds no line breaks or control characters.", key));
    }
    into.push_back(std::move(setting));
    return Done{};
  }

  Error refuse(const std::string& key, int line) const {
    return planError(path_, line, fmt::format("{}: it takes a number, a text, or a list of these.", shortened(key)));
  }

  /// toml++ sorts by key; the file's order says which list varies fastest.
  static void inOrder(std::vector<PlanSetting>& settings) {
    std::stable_sort(settings.begin(), settings.end(), [](const auto& a, const auto& b) { return a.line < b.line; });
  }

  /// Shared settings come first, unless the condition has its own. "pre-learning = false" drops the shared settings of
  /// pre-learning, and "base = false" all shared settings.
  static void addShared(const std::vector<PlanSetting>& shared, std::vector<PlanSetting>& own) {
    const auto base = std::find_if(own.begin(), own.end(), [](const PlanSetting& s) { return s.key == "base"; });
    if (base != own.end() && base->values == std::vector<std::string>{"false"}) {
      own.erase(base);
      return;
    }
    const auto has = [&](const std::string& key) {
      return std::any_of(own.begin(), own.end(), [&](const PlanSetting& s) { return s.key == key; });
    };
    std::vector<PlanSetting> all;
    for (const PlanSetting& s : shared)
      if (!has(s.key) && !(s.key.starts_with("pre-learning.") && has("pre-learning"))) all.push_back(s);
    all.insert(all.end(), own.begin(), own.end());
    own = std::move(all);
  }

  const std::string& path_;
};

nlohmann::json asJson(const toml::node& node) {
  nlohmann::json json;
  if (const auto* s = node.as_string()) json = s->get();
  if (const auto* n = node.as_integer()) json = n->get();
  if (const auto* f = node.as_floating_point()) json = f->get();
  if (const auto* b = node.as_boolean()) json = b->get();
  if (const auto* list = node.as_array()) {
    json = nlohmann::json::array();
    for (const toml::node& element : *list) json.push_back(asJson(element));
  }
  if (const auto* table = node.as_table()) {
    json = nlohmann::json::object();
    for (const auto& [key, element] : *table) json[std::string(key.str())] = asJson(element);
  }
  return json;
}

/// TOML's whole numbers end at 2⁶³ − 1 and seeds at 2⁶⁴ − 1: a larger one, alone on its line, is put in quotes.
std::string withLargeSeeds(const std::string& text) {
  constexpr std::size_t kDigitsOfInt64 = 19;
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    std::string line = text.substr(begin, end - begin);
    begin = end;
    const auto equals = line.find('=');
    const auto key = line.substr(0, line.find_first_of(" \t="));
    const auto first = equals == std::string::npos ? equals : line.find_first_not_of(" \t", equals + 1);
    if (key == "seed" && first != std::string::npos) {
      const auto last = std::min(line.find_first_not_of("0123456789_", first), line.size());
      std::string digits = line.substr(first, last - first);
      std::erase(digits, '_');
      if (digits.size() >= kDigitsOfInt64) line.replace(first, last - first, "\"" + digits + "\"");
    }
    out += line;
  }
  return out;
}

Result<toml::table> parsed(const std::string& text, const std::string& path) {
  auto root = parseLimitedToml(withLargeSeeds(text));
  if (auto* table = std::get_if<toml::table>(&root)) return std::move(*table);
  const auto& trouble = std::get<TomlTrouble>(root);
  return planError(path, trouble.line,
                   trouble.line > 0 ? fmt::format("this is not TOML: {}.", trouble.sentence) : trouble.sentence + ".");
}

}  // namespace

Result<PlanFile> parsePlanFile(const std::string& text, const std::string& path) {
  const auto root = parsed(text, path);
  return root ? Reader(path).read(*root) : root.error();
}

Result<nlohmann::json> parseRecipeBlocks(const std::string& text, const std::string& path) {
  const auto root = parsed(text, path);
  if (!root) return root.error();
  nlohmann::json blocks = {{"shows", nlohmann::json::array()},
                           {"table", nlohmann::json::array()},
                           {"figure", nlohmann::json::array()},
                           {"claim", nlohmann::json::array()}};
  for (auto& [key, value] : blocks.items()) {
    const toml::node* node = root->get(key);
    if (!node) continue;
    const bool list = key == "shows" || key == "table";
    if (!node->is_array() || (!list && !node->as_array()->is_homogeneous<toml::table>()))
      return planError(path, lineOf(*node),
                       fmt::format("{}: {} is expected.", key, list ? "a list" : "[[" + key + "]]"));
    value = asJson(*node);
  }
  blocks["apart"] = (*root)["apart"].value_or(false);
  return blocks;
}

Status unknownKey(const std::string& key, const std::vector<std::string>& known) {
  const std::string near = nearestWord(key, known);
  return Error{fmt::format("there is no \"{}\"{}; it takes {}.", shortened(key),
                           near.empty() ? "" : ", did you mean " + near, joinWords(known))};
}
Status readNumber(const std::string& key, const std::string& text, double low, double high,
                  std::optional<double>& out) {
  const auto value = parseValue(Parameter{.key = key, .low = low, .high = high}, text);
  if (!value) return value.error();
  out = *value;
  return Done{};
}
Status readCount(const std::string& key, const std::string& text, std::int64_t most, std::optional<std::int64_t>& out) {
  const auto value = parseWhole(key, text, 1, static_cast<std::uint64_t>(most));
  if (!value) return value.error();
  out = static_cast<std::int64_t>(*value);
  return Done{};
}
Status readCount(const std::string& key, const std::string& text, int most, int& out) {
  std::optional<std::int64_t> value;
  if (const Status s = readCount(key, text, std::int64_t{most}, value); !s) return s;
  out = static_cast<int>(*value);
  return Done{};
}

Status readFlag(const std::string& key, const std::string& text, bool& out) {
  out = text == "true";
  if (text == "true" || text == "false") return Done{};
  return Error{fmt::format("{}: \"{}\" is not allowed; it takes true or false.", key, shortened(text))};
}

Status readSeed(const std::string& text, std::uint64_t& out) {
  const auto seed = parseSeed("seed", text);
  if (!seed) return seed.error();
  out = *seed;
  return Done{};
}

}  // namespace surefoot
