// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that are arithmetic, or hold exactly: they need no statistics.
#include <fmt/format.h>

#include <cmath>

#include "core/basics/typed_json.h"
#include "core/experiment/configuration_json.h"
#include "core/life/rule_of_thumb.h"
#include "core/recipes/figure.h"
#include "core/recipes/judge.h"
#include "core/recipes/same_stream.h"

namespace surefoot {

namespace {

using Json = nlohmann::json;

/// To the digits printed; a last digit may be cut instead of rounded.
bool asPrinted(double ours, double expected, double digits) {
  return std::abs(ours - expected) < std::pow(10.0, -digits);
}

std::vector<double> numbers(const Json& arguments, const char* key) {
  std::vector<double> list;
  for (const Json& v : partOf(arguments, key))
    if (v.is_number()) list.push_back(v);
  return list;
}

}  // namespace

Verdict Judge::eachRow(const std::function<Verdict(const Json& row)>& judgeRow) {
  std::vector<Verdict> verdicts;
  for (const Json& row : partOf(arguments_, "rows")) {
    verdicts.push_back(judgeRow(row));
    if (!problem_.empty()) return Verdict::Undecided;
  }
  if (verdicts.empty()) complain("rows", "a list is expected");
  return all(verdicts);
}

Verdict Judge::rule() {
  return eachRow([&](const Json& row) {
    const double expected = numberIn(row, "expected");
    const double ours = ruleOfThumb(numberIn(row, "discount", 0.98), numberIn(row, "transitions"),
                                    numberIn(row, "goal", 200), numberIn(row, "time", 0));
    if (!std::isfinite(ours) || !std::isfinite(expected))
      complain("rows", "transitions and expected are needed in each");
    note(fmt::format("{:.6g} for {:g}", ours, expected));
    if (!j_.ours) j_.ours = ours;
    return agreesIf(asPrinted(ours, expected, numberIn(row, "digits", 0)));
  });
}

const Evidence* Judge::conditionOf(const Json& row, const char* key) {
  const Group found = fitting(textIn(row, key));
  if (found.size() == 1) return found[0];
  complain("rows", fmt::format("no single condition is called \"{}\"", textIn(row, key)));
  return nullptr;
}

Verdict Judge::parameters() {
  return eachRow([&](const Json& row) {
    const Evidence* e = conditionOf(row, "condition");
    const Evidence* of = row.contains("of") ? conditionOf(row, "of") : e;
    const auto parameter = [&](const Evidence* owner, const char* key, double otherwise) {
      if (!owner || !row.contains(key)) return otherwise;
      const double value = numberIn(partOf(owner->configuration, "parameters"), textIn(row, key));
      if (!std::isfinite(value))
        complain("rows", fmt::format("\"{}\" is no number of {}", textIn(row, key), e->name()));
      return value;
    };
    const double ours = parameter(e, "key", std::nan("")) * parameter(e, "times", 1) / parameter(of, "over", 1);
    const double expected = numberIn(row, "expected");
    if (!std::isfinite(ours) || !std::isfinite(expected)) complain("rows", "key and expected are needed in each");
    note(fmt::format("{:.6g} for {:g}", ours, expected));
    if (!j_.ours) j_.ours = ours;
    return agreesIf(asPrinted(ours, expected, numberIn(row, "digits", 0)));
  });
}

// Single points of a figure of policies or representations.
Verdict Judge::drawn() {
  const FigureSpec spec{.name = claim_.id,
                        .title = claim_.says,
                        .kind = text("draws", ""),
                        .conditions = {},
                        .along = {},
                        .q = numbers(arguments_, "q"),
                        .state = numbers(arguments_, "state")};
  return eachRow([&](const Json& row) {
    const Evidence* e = conditionOf(row, "condition");
    if (!e) return Verdict::Undecided;
    const auto figure = makeLiveFigure(registry_, spec, {e});
    if (!figure) {
      complain("draws", figure.error().message);
      return Verdict::Undecided;
    }
    const FigureSeries& series = figure->series[0];
    const double x = numberIn(row, "x");
    const auto place = std::find(series.x.begin(), series.x.end(), x);
    if (place == series.x.end()) {
      complain("rows", fmt::format("x = {} is no point of the figure", x));
      return Verdict::Undecided;
    }
    const double ours = series.y[static_cast<std::size_t>(place - series.x.begin())].value;
    const double expected = numberIn(row, "expected"), within = numberIn(row, "within", 1e-9);
    const double low = numberIn(row, "low", expected - within), high = numberIn(row, "high", expected + within);
    if (!(low <= high)) complain("rows", "expected, or low and high, are needed in each");
    if (!j_.ours) j_.ours = ours;
    const bool holds = ours >= low && ours <= high;
    if (!holds) note(fmt::format("{} at {}: {:.6g}", e->name(), x, ours));
    return agreesIf(holds);
  });
}

Verdict Judge::sameValues() {
  if (conditions_.size() != 2) complain("conditions", "two are expected");
  if (!problem_.empty()) return Verdict::Undecided;
  const auto first = configurationFromJson(registry_, conditions_[0]->configuration, conditions_[0]->name());
  const auto second = configurationFromJson(registry_, conditions_[1]->configuration, conditions_[1]->name());
  if (!first || !second) complain("conditions", (first ? second : first).error().message);
  if (!problem_.empty()) return Verdict::Undecided;
  const auto largest = largestDifference(registry_, *first, *second, static_cast<int>(number("steps", 100'000)));
  if (!largest) complain("conditions", largest.error().message);
  if (!problem_.empty()) return Verdict::Undecided;
  j_.ours = *largest;
  note(fmt::format("largest difference of a value {:.2g}", *largest));
  return agreesIf(*largest < number("within", 1e-9));
}

}  // namespace surefoot
