// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/laboratory/findings.h"
#include "core/laboratory/statistics_text.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson number(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson(nullptr);
}
OrderedJson asJson(const Interval& i) {
  return {{"value", number(i.value)}, {"low", number(i.low)}, {"high", number(i.high)}};
}
OrderedJson asJson(const TestResult& t) {
  OrderedJson json = {{"statistic", number(t.statistic)}, {"degrees_of_freedom", t.degrees1}, {"p", t.p}};
  if (t.degrees2 > 0) json["degrees_of_freedom"] = {t.degrees1, t.degrees2};
  return json;
}
template <class T>
OrderedJson asJson(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_arithmetic_v<T>)
    return *value;
  else
    return asJson(*value);
}

OrderedJson asJson(const Comparison& c) {
  return {{"change_per_cent", asJson(c.change)},
          {"anova", asJson(c.anova)},
          {"significant", c.significant()},
          {"welch", asJson(c.welch)},
          {"paired", asJson(c.paired)},
          {"holm_p", c.holm},
          {"effect_size", asJson(c.effect)},
          {"lives_needed", asJson(c.livesNeeded)},
          {"minutes_difference", asJson(c.minutes)},
          {"change_per_cent_until_reference_ends", asJson(c.changeAtItsEnd)}};
}

/// "< 1e-10", "0.0031"
std::string pText(double p) {
  if (p < 1e-10) return "< 1e-10";
  return p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
}

/// Characters as a terminal shows them, so that columns line up under letters that take several bytes.
std::string padded(const std::string& s, std::size_t width) {
  std::size_t shown = 0;
  for (const char c : s) shown += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return s + std::string(shown < width ? width - shown : 0, ' ');
}

bool isReference(const StoredPlan& plan, const std::string& name) {
  return std::any_of(plan.conditions.begin(), plan.conditions.end(),
                     [&](const StoredCondition& c) { return c.reference == name; });
}

}  // namespace

nlohmann::ordered_json findingsAsJson(const Findings& findings) {
  OrderedJson list = OrderedJson::array();
  for (const Finding& f : findings.conditions) {
    OrderedJson condition = {{"name", f.name},
                             {"reference", f.reference},
                             {"lives", f.lives},
                             {"diverged", f.diverged},
                             {"end_of_learning", f.end ? OrderedJson(*f.end) : OrderedJson(nullptr)},
                             {"largest_change_after", f.largestChangeAfter},
                             {"falls", asJson(f.falls)},
                             {"minutes", asJson(f.minutes)},
                             {"all_falls", asJson(f.allFalls)},
                             {"falls_per_episode_at_the_end", asJson(f.endPerformance)},
                             {"average_reward", asJson(f.averageReward)},
                             {"transitions",
                              {{"success_during", asJson(f.successDuring)},
                               {"success_after", asJson(f.successAfter)},
                               {"failure_during", asJson(f.failureDuring)},
                               {"failure_after", asJson(f.failureAfter)}}},
                             {"rule_of_thumb", asJson(f.threshold)}};
    if (f.qFunctions > 0) {
      OrderedJson between = nullptr;
      if (f.betweenQFunctions)
        between = {{"variance_share", f.betweenQFunctions->share}, {"test", asJson(f.betweenQFunctions->test)}};
      condition["pre_learning"] = {{"q_functions", f.qFunctions}, {"at_cap", f.atCap}, {"between", between}};
    }
    if (f.comparison) condition["against_reference"] = asJson(*f.comparison);
    condition["warnings"] = f.warnings;
    list.push_back(std::move(condition));
  }
  return {{"title", findings.plan.title},   {"version", findings.plan.version}, {"seed", findings.plan.seed},
          {"paired", findings.plan.paired}, {"complete", findings.complete},    {"conditions", list}};
}

std::string findingsAsTable(const Findings& findings) {
  std::size_t width = 12;
  for (const Finding& f : findings.conditions) width = std::max(width, f.name.size());
  std::string out = findings.plan.title.empty() ? "" : findings.plan.title + "\n";
  out +=
      fmt::format("{} {} {} {} {} {} {}\n", padded("", width), padded("lives", 6), padded("end", 6),
                  padded("falls", 16), padded("minutes", 13), padded("change, % (95 %)", 24), padded("p (ANOVA)", 10));
  for (const Finding& f : findings.conditions) {
    std::string change, p;
    if (f.comparison) {
      const Interval& i = f.comparison->change;
      change = fmt::format("{:+.1f} ({:+.1f} … {:+.1f})", i.value, i.low, i.high);
      p = pText(f.comparison->p()) + (f.comparison->significant() ? " X" : "");
    } else if (isReference(findings.plan, f.name)) {
      change = "reference";
    }
    out += fmt::format("{} {} {} {} {} {} {}\n", padded(f.name, width), padded(std::to_string(f.lives), 6),
                       padded(f.end ? std::to_string(*f.end) : "–", 6), padded(plusMinusText(f.falls, 1), 16),
                       padded(plusMinusText(f.minutes, 2), 13), padded(change, 24), p);
  }
  for (const Finding& f : findings.conditions)
    for (const std::string& warning : f.warnings) out += fmt::format("{}: {}.\n", f.name, warning);
  if (!findings.complete) out += "Not all planned lives are there.\n";
  return out;
}

}  // namespace surefoot
