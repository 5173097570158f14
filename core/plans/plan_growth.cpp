// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "core/basics/typed_json.h"

namespace surefoot {

namespace {

constexpr int kMostGrown = 100'000, kMostValuesTried = 1024;

using Json = nlohmann::json;
using Readers = std::map<std::string, std::function<Status(const PlanSetting&)>>;

Status toNumber(const PlanSetting& s, double low, double high, double& out) {
  std::optional<double> number;
  if (const Status read = readNumber(s.key, s.values.front(), low, high, number); !read) return read;
  out = *number;
  return Done{};
}

Status readAll(const std::vector<PlanSetting>& settings, const std::string& path, const char* what,
               const Readers& readers, const std::function<Status(const PlanSetting&)>& other) {
  for (const PlanSetting& s : settings) {
    const auto reader = readers.find(s.key);
    Status status = Done{};
    if (reader == readers.end()) {
      status = other(s);
    } else if (s.values.size() > 1) {
      status = Error{fmt::format("{}: one value is expected.", s.key)};
    } else {
      status = reader->second(s);
    }
    if (!status) return planError(path, s.line, fmt::format("{}: {}", what, status.error().message));
  }
  return Done{};
}

std::vector<std::string> namesOf(const Readers& readers, const char* more) {
  std::vector<std::string> names;
  for (const auto& [name, reader] : readers) names.push_back(name);
  if (*more) names.emplace_back(more);
  return names;
}

}  // namespace

std::vector<int> DecidedLives::looks() const {
  std::vector<int> all;
  for (int n = atLeast; n < atMost; n += group) all.push_back(n);
  all.push_back(atMost);
  return all;
}

std::vector<double> DecidedLives::levels() const {
  std::vector<double> all;
  double spent = 0;
  for (const int n : looks()) {
    const double soFar = level * std::log(1 + (std::numbers::e - 1) * n / atMost);
    all.push_back(soFar - spent);
    spent = soFar;
  }
  return all;
}

std::vector<std::string> PlanSearch::valuesToTry() const {
  std::vector<std::string> all;
  for (int i = 0; i < values; ++i) {
    const double share = static_cast<double>(i) / (values - 1);
    const double value = logarithmic ? low * std::pow(high / low, share) : low + (high - low) * share;
    std::string text = fmt::format("{:.3g}", value);
    if (all.empty() || all.back() != text) all.push_back(std::move(text));
  }
  return all;
}

std::vector<int> PlanSearch::rounds() const {
  const auto many = static_cast<int>(std::max<std::size_t>(candidates.size(), 2));
  const int rounds = static_cast<int>(std::ceil(std::log2(many)));
  std::vector<int> lived;
  int left = many, each = 0;
  for (int r = 0; r < rounds; ++r, left = (left + 1) / 2) {
    each += std::max(2, budget / (rounds * left));
    lived.push_back(each);
  }
  return lived;
}

Result<DecidedLives> readDecided(const std::vector<PlanSetting>& settings, const std::string& path) {
  DecidedLives d;
  const Readers readers = {
      {"at_least", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostGrown, d.atLeast); }},
      {"at_most", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostGrown, d.atMost); }},
      {"group", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostGrown, d.group); }},
      {"level", [&](const PlanSetting& s) { return toNumber(s, 1e-6, 0.5, d.level); }},
      {"widest", [&](const PlanSetting& s) { return toNumber(s, 0.1, 99, d.widest); }},
      {"measure", [&](const PlanSetting& s) { return d.measure = s.values[0], Status(Done{}); }}};
  const auto unknown = [&](const PlanSetting& s) { return unknownKey(s.key, namesOf(readers, "")); };
  if (const Status s = readAll(settings, path, "decided", readers, unknown); !s) return s.error();
  constexpr int kFewest = 5;  // with fewer no test is to be trusted
  if (d.atLeast < kFewest || d.atMost < d.atLeast)
    return planError(path, settings.empty() ? 0 : settings.front().line,
                     fmt::format("decided: at_least {} and at_most {}: at least {} lives, and no fewer at most.",
                                 d.atLeast, d.atMost, kFewest));
  return d;
}

Result<PlanSearch> readSearch(const std::vector<PlanSetting>& settings, const std::string& path) {
  PlanSearch p;
  const Readers readers = {
      {"condition", [&](const PlanSetting& s) { return p.condition = s.values[0], Status(Done{}); }},
      {"values", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostValuesTried, p.values); }},
      {"scale",
       [&](const PlanSetting& s) -> Status {
         p.logarithmic = s.values[0] == "logarithmic";
         if (p.logarithmic || s.values[0] == "linear") return Done{};
         return Error{"scale: it takes linear or logarithmic."};
       }},
      {"budget", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostGrown, p.budget); }},
      {"fresh", [&](const PlanSetting& s) { return readCount(s.key, s.values[0], kMostGrown, p.fresh); }},
      {"minimise", [&](const PlanSetting& s) { return p.minimise = s.values[0], Status(Done{}); }},
      {"keeping", [&](const PlanSetting& s) { return p.keeping = s.values[0], Status(Done{}); }},
      {"worse", [&](const PlanSetting& s) { return toNumber(s, 0, 1000, p.worse); }}};
  const auto range = [&](const PlanSetting& s) -> Status {
    if (!s.key.starts_with("set.")) return unknownKey(s.key, namesOf(readers, "set"));
    const Error two{fmt::format("{}: one parameter with its range is expected, [low, high].", s.key)};
    if (!p.key.empty() || s.values.size() != 2) return two;
    p.key = s.key.substr(4);
    for (std::size_t i = 0; i < 2; ++i) {
      std::optional<double> end;
      if (const Status read = readNumber(s.key, s.values[i], -1e9, 1e9, end); !read) return read;
      (i == 0 ? p.low : p.high) = *end;
    }
    return p.low < p.high ? Status(Done{}) : Status(two);
  };
  if (const Status s = readAll(settings, path, "search", readers, range); !s) return s.error();
  const int line = settings.empty() ? 0 : settings.front().line;
  if (p.condition.empty() || p.key.empty() || p.values < 2)
    return planError(path, line,
                     "search: it takes condition, the name of one, set.KEY = [low, high], and values from 2 on.");
  if (p.logarithmic && p.low * p.high <= 0)
    return planError(path, line,
                     "search: a logarithmic scale keeps to one side of 0; scale = \"linear\" goes from anywhere.");
  return p;
}

Json growthAsJson(const PlanGrowth& g) {
  Json json = Json::object();
  if (const auto& d = g.decided)
    json["decided"] = {{"at_least", d->atLeast}, {"at_most", d->atMost}, {"group", d->group},
                       {"level", d->level},      {"widest", d->widest},  {"measure", d->measure}};
  if (const auto& s = g.search)
    json["search"] = {{"condition", s->condition}, {"key", s->key},       {"low", s->low},
                      {"high", s->high},           {"values", s->values}, {"logarithmic", s->logarithmic},
                      {"budget", s->budget},       {"fresh", s->fresh},   {"minimise", s->minimise},
                      {"keeping", s->keeping},     {"worse", s->worse},   {"candidates", s->candidates}};
  return json;
}

std::optional<PlanGrowth> growthFromJson(const Json& json) {
  PlanGrowth g;
  const auto whole = [](const Json& from, const char* key, int least, int& out) {
    const double v = numberIn(from, key);
    const bool fine = v >= least && v <= kMostGrown && v == std::floor(v);
    if (fine) out = static_cast<int>(v);
    return fine;
  };
  if (json.contains("decided")) {
    const Json& from = partOf(json, "decided");
    DecidedLives d;
    d.level = numberIn(from, "level"), d.widest = numberIn(from, "widest"), d.measure = textIn(from, "measure");
    if (!whole(from, "at_least", 2, d.atLeast) || !whole(from, "at_most", d.atLeast, d.atMost) ||
        !whole(from, "group", 1, d.group) || !(d.level > 0 && d.level < 1) || !(d.widest > 0))
      return std::nullopt;
    g.decided = d;
  }
  if (json.contains("search")) {
    const Json& from = partOf(json, "search");
    PlanSearch s;
    s.condition = textIn(from, "condition"), s.key = textIn(from, "key");
    s.minimise = textIn(from, "minimise"), s.keeping = textIn(from, "keeping");
    s.low = numberIn(from, "low"), s.high = numberIn(from, "high"), s.worse = numberIn(from, "worse");
    s.logarithmic = from.contains("logarithmic") && from["logarithmic"] == true;
    for (const Json& name : partOf(from, "candidates"))
      if (name.is_string()) s.candidates.push_back(name);
    if (!whole(from, "values", 2, s.values) || !whole(from, "budget", 1, s.budget) ||
        !whole(from, "fresh", 1, s.fresh) || s.candidates.size() < 2 || !std::isfinite(s.worse))
      return std::nullopt;
    g.search = s;
  }
  return g ? std::optional(g) : std::nullopt;
}

}  // namespace surefoot
