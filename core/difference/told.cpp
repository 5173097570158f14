// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/difference/told.h"

#include <fmt/format.h>

#include "core/basics/typed_json.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {

constexpr const char* kNothing = "nothing";

template <class T>
std::string orNothing(const std::optional<T>& value) {
  return value ? fmt::format("{}", *value) : kNothing;
}

std::string beganWith(const Configuration& c) {
  return c.beganWith.is_object() ? textIn(c.beganWith, c.beganWith.contains("content") ? "content" : "hash") : kNothing;
}

class Telling {
 public:
  void compare(const std::string& what, const std::string& first, const std::string& second) {
    if (first != second) told.push_back({{what, first, second}, {}});
  }
  std::vector<ToldOtherwise> told;
};

std::string nothingIfEmpty(const std::string& text) {
  return text.empty() ? kNothing : text;
}

void compareNames(const Names& a, const Names& b, Telling& t) {
  t.compare("environment", a.environment, b.environment);
  t.compare("preset", nothingIfEmpty(a.preset), nothingIfEmpty(b.preset));
  t.compare("scenario", nothingIfEmpty(a.scenario), nothingIfEmpty(b.scenario));
  t.compare("agent", a.agent, b.agent);
  t.compare("features", a.features, b.features);
  t.compare("policy", a.policy, b.policy);
}

/// Parameters that both have: which others there are follows from the names.
void compareParameters(const Parameters& a, const Parameters& b, Telling& t) {
  for (const auto& entry : a.all())
    if (const auto* other = b.find(entry.parameter.key))
      t.compare(entry.parameter.key, formatValue(entry.parameter, entry.value),
                formatValue(other->parameter, other->value));
}

/// "push = 0.05"
std::string textOf(const CommandText& c) {
  return fmt::format("{} = {}", c.key, c.value);
}

std::optional<ToldOtherwise> firstOtherCommand(const std::vector<CommandText>& a, const std::vector<CommandText>& b) {
  std::size_t i = 0;
  const auto same = [](const CommandText& x, const CommandText& y) {
    return x.step == y.step && x.key == y.key && x.value == y.value;
  };
  while (i < a.size() && i < b.size() && same(a[i], b[i])) ++i;
  const CommandText* first = i < a.size() ? &a[i] : nullptr;
  const CommandText* second = i < b.size() ? &b[i] : nullptr;
  if (!first && !second) return std::nullopt;
  if (first && second && first->step != second->step) (first->step < second->step ? second : first) = nullptr;
  return ToldOtherwise{{"command", first ? textOf(*first) : kNothing, second ? textOf(*second) : kNothing},
                       first ? first->step : second->step};
}

}  // namespace

std::vector<ToldOtherwise> toldOtherwise(const Journal& first, const Journal& second) {
  const Configuration &a = first.configuration, &b = second.configuration;
  Telling t;
  compareNames(a.names, b.names, t);
  t.compare("seed", std::to_string(a.seed), std::to_string(b.seed));
  t.compare("number of the life", std::to_string(first.life), std::to_string(second.life));
  t.compare("minutes", orNothing(a.minutes), orNothing(b.minutes));
  t.compare("episodes", orNothing(a.episodes), orNothing(b.episodes));
  t.compare("until", orNothing(a.until), orNothing(b.until));
  t.compare("began with", beganWith(a), beganWith(b));
  t.compare("guardian", a.teacher ? contentOf(*a.teacher) : kNothing, b.teacher ? contentOf(*b.teacher) : kNothing);
  compareParameters(a.parameters, b.parameters, t);
  if (auto command = firstOtherCommand(a.commands, b.commands)) t.told.push_back(std::move(*command));
  return std::move(t.told);
}

}  // namespace surefoot
