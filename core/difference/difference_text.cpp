// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/basics/typed_json.h"
#include "core/difference/difference.h"

namespace surefoot {

namespace {

std::string valuesText(const TwoValues& v) {
  return fmt::format("{}: {} and {}", v.what, v.first, v.second);
}

/// "after 500 steps, in episode 3"
std::string placeText(const Parting& p) {
  if (p.life) return fmt::format("life {}, episode {}", *p.life, p.episode.value_or(0));
  if (!p.step) return "the heads";
  const std::string steps = fmt::format("after {} equal steps", *p.step);
  return p.episode ? fmt::format("{}, in episode {}", steps, *p.episode) : steps;
}

}  // namespace

std::string differenceText(const RecordDifference& d, const std::string& first, const std::string& second) {
  const char* what = d.kind == RecordKind::Log ? "rows" : "steps";
  std::string text;
  if (!d.differ())
    text = fmt::format("{} and {} are the same: {} {}.\n", first, second, d.same, what);
  else
    text = fmt::format("{} and {} differ.\n", first, second);
  for (const ToldOtherwise& t : d.told)
    text += t.step ? fmt::format("  told at step {}: {} and {}\n", *t.step, t.first, t.second)
                   : fmt::format("  told {}\n", valuesText(t));
  if (d.parting)
    text += fmt::format("  {}: {}\n", placeText(*d.parting), valuesText(*d.parting));
  else if (d.differ() && d.note.empty())
    text += fmt::format("  all {} steps are the same\n", d.same);
  if (!d.note.empty()) text += fmt::format("  {}\n", d.note);
  return text;
}

std::string differenceAsJson(const RecordDifference& d) {
  using OrderedJson = nlohmann::ordered_json;
  const auto values = [](const TwoValues& v) {
    return OrderedJson{{"in", v.what}, {"first", v.first}, {"second", v.second}};
  };
  OrderedJson json = {{"differ", d.differ()}, {"kind", nameOf(d.kind)}, {"same", d.same}};
  json["told"] = OrderedJson::array();
  for (const ToldOtherwise& t : d.told) {
    OrderedJson told = values(t);
    if (t.step) told["step"] = *t.step;
    json["told"].push_back(std::move(told));
  }
  json["parting"] = nullptr;
  if (d.parting) {
    OrderedJson parting = values(*d.parting);
    for (const auto& [key, value] : {std::pair{"step", d.parting->step}, std::pair{"life", d.parting->life},
                                     std::pair{"episode", d.parting->episode}})
      if (value) parting[key] = *value;
    json["parting"] = std::move(parting);
  }
  if (!d.note.empty()) json["note"] = d.note;
  return jsonText(json, 2, true) + "\n";
}

}  // namespace surefoot
