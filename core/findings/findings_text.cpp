// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/findings/findings.h"
#include "core/statistics/statistics_text.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson asJson(const Interval& i) {
  return {{"value", numberAsJson(i.value)}, {"low", numberAsJson(i.low)}, {"high", numberAsJson(i.high)}};
}
OrderedJson asJson(const TestResult& t) {
  OrderedJson json = {{"statistic", numberAsJson(t.statistic)},
                      {"degrees_of_freedom", numberAsJson(t.degrees1)},
                      {"p", numberAsJson(t.p)}};
  if (t.degrees2 > 0) json["degrees_of_freedom"] = {t.degrees1, t.degrees2};
  return json;
}
template <class T>
OrderedJson asJson(const std::optional<T>& value) {
  if (!value) return nullptr;
  if constexpr (std::is_arithmetic_v<T>)
    return OrderedJson(*value);
  else
    return asJson(*value);
}

OrderedJson asJson(const Comparison& c) {
  OrderedJson fixed = nullptr;
  if (c.fixed)
    fixed = {
        {"measure", c.fixed->measure}, {"change_per_cent", asJson(c.fixed->change)}, {"p", numberAsJson(c.fixed->p)}};
  OrderedJson counts = nullptr;
  if (c.counts)
    counts = {{"ratio", asJson(c.counts->ratio)},
              {"p", numberAsJson(c.counts->p)},
              {"deviation_between_q_functions", numberAsJson(c.counts->deviation)},
              {"dispersion", numberAsJson(c.counts->dispersion)}};
  return {{"at_a_fixed_moment", fixed},
          {"as_counts", counts},
          {"change_per_cent", asJson(c.change)},
          {"difference", asJson(c.difference)},
          {"p", numberAsJson(c.p())},
          {"anova", asJson(c.anova)},
          {"significant", c.ofUnits ? OrderedJson(c.significant()) : OrderedJson(nullptr)},
          {"welch", asJson(c.welch)},
          {"paired", asJson(c.paired)},
          {"holm_p", numberAsJson(c.holm)},
          {"effect_size", asJson(c.effect)},
          {"lives_needed", asJson(c.livesNeeded)},
          {"minutes_difference", asJson(c.minutes)},
          {"change_per_cent_until_reference_ends", asJson(c.changeAtItsEnd)}};
}

/// "< 1e-10", "0.0031"; "–" without a test
std::string pText(double p) {
  if (std::isnan(p)) return "–";
  if (p < 1e-10) return "< 1e-10";
  return p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
}

/// Characters as a terminal shows them, so that columns line up under letters that take several bytes.
std::size_t shownLength(const std::string& s) {
  std::size_t shown = 0;
  for (const char c : s) shown += (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  return shown;
}
std::string padded(const std::string& s, std::size_t width) {
  const std::size_t shown = shownLength(s);
  return s + std::string(shown < width ? width - shown : 0, ' ');
}

/// "12.0 (10.1 … 14.2)"
std::string withEnds(const Interval& i, int decimals) {
  if (!std::isfinite(i.value)) return "–";
  std::string text = fmt::format("{:.{}f}", i.value, decimals);
  if (i.known()) text += fmt::format(" ({:.{}f} … {:.{}f})", i.low, decimals, i.high, decimals);
  return text;
}

std::string plain(const Interval& i, int decimals) {
  return withEnds({i.value, NAN, NAN}, decimals);
}

/// "616 (564 … 697)"; "never": learning did not end.
std::string endText(const Finding& f) {
  const auto text = [](double v) { return std::isfinite(v) ? fmt::format("{:.0f}", v) : std::string("never"); };
  const Interval& i = f.endRange;
  if (i.low == i.high) return text(i.value);
  return fmt::format("{} ({} … {})", text(i.value), text(i.low), text(i.high));
}

/// The falls up to moments that do not depend on when learning ended.
std::string fixedTable(const Findings& findings, std::size_t width) {
  std::string out = fmt::format("{} {} {} {} {} {} {} {} {}\n", padded("", width), padded("lives", 6),
                                padded("explored %", 10), padded("by min 1", 8), padded("3", 6), padded("6", 13),
                                padded("episode 330", 12), padded("change, % (95 %)", 24), "p");
  for (const Finding& f : findings.conditions) {
    const auto& fixed = f.comparison ? f.comparison->fixed : std::optional<FixedChange>();
    const std::string change = fixed ? changeText(fixed->change, 1) : "";
    const auto falls = [](const Interval& i) { return std::isfinite(i.value) ? plusMinusText(i, 1) : "–"; };
    out +=
        fmt::format("{} {} {} {} {} {} {} {} {}\n", padded(f.name, width), padded(std::to_string(f.lives), 6),
                    padded(plain({100 * f.exploring.value, NAN, NAN}, 2), 10), padded(plain(f.fallsByMinute[0], 1), 8),
                    padded(plain(f.fallsByMinute[1], 1), 6), padded(falls(f.fallsByMinute[2]), 13),
                    padded(falls(f.fallsByEpisode), 12), padded(change, 24), fixed ? pText(fixed->p) : "");
  }
  return out;
}

/// How the lives spread, and the greedy policy at last.
std::string spreadTable(const Findings& findings, std::size_t width) {
  std::string out = fmt::format("\n{} {} {} {} {} {}\n", padded("", width), padded("IQM (95 %)", 22), padded("90 %", 7),
                                padded("P(fewer) (95 %)", 22), padded("no fall", 8), "greedy falls, end");
  for (const Finding& f : findings.conditions) {
    out += fmt::format("{} {} {} {} {} {}\n", padded(f.name, width), padded(withEnds(f.spread.iqm, 1), 22),
                       padded(plain(f.spread.most, 1), 7), padded(f.improvement ? withEnds(*f.improvement, 2) : "", 22),
                       padded(f.lives > 0 ? fmt::format("{:.0f} %", 100 * f.spread.withoutFall) : "–", 8),
                       withEnds(f.finalFalls, 4));
  }
  return out;
}

bool isReference(const StoredPlan& plan, const std::string& name) {
  return std::any_of(plan.conditions.begin(), plan.conditions.end(),
                     [&](const StoredCondition& c) { return c.reference == name; });
}

}  // namespace

std::string changeText(const Comparison& c, int decimals) {
  const bool inPerCent = std::isfinite(c.change.value);
  const Interval& i = inPerCent ? c.change : c.difference;
  if (!std::isfinite(i.value)) return "–";
  std::string text = signedText(i.value, decimals) + (inPerCent ? "" : " falls");
  if (i.known()) text += fmt::format(" ({} … {})", signedText(i.low, decimals), signedText(i.high, decimals));
  return text;
}

nlohmann::ordered_json findingsAsJson(const Findings& findings) {
  OrderedJson list = OrderedJson::array();
  for (const Finding& f : findings.conditions) {
    OrderedJson condition = {
        {"name", f.name},
        {"reference", f.reference},
        {"lives", f.lives},
        {"diverged", f.diverged},
        {"end_of_learning", f.end ? OrderedJson(*f.end) : OrderedJson(nullptr)},
        {"end_of_learning_low", numberAsJson(f.endRange.low)},
        {"end_of_learning_high", numberAsJson(f.endRange.high)},
        {"largest_change_after", f.largestChangeAfter},
        {"falls", asJson(f.falls)},
        {"minutes", asJson(f.minutes)},
        {"all_falls", asJson(f.allFalls)},
        {"falls_per_episode_at_the_end", asJson(f.endPerformance)},
        {"average_reward", asJson(f.averageReward)},
        {"falls_by_minute",
         {{"1", asJson(f.fallsByMinute[0])}, {"3", asJson(f.fallsByMinute[1])}, {"6", asJson(f.fallsByMinute[2])}}},
        {"falls_by_episode_330", asJson(f.fallsByEpisode)},
        {"spread_of_falls",
         {{"interquartile_mean", asJson(f.spread.iqm)},
          {"median", asJson(f.spread.median)},
          {"quantile_90", asJson(f.spread.most)},
          {"mean_of_worst_10_per_cent", asJson(f.spread.worst)},
          {"share_without_a_fall", numberAsJson(f.spread.withoutFall)}}},
        {"probability_of_improvement", asJson(f.improvement)},
        {"exploring", asJson(f.exploring)},
        {"final_greedy", {{"falls", asJson(f.finalFalls)}, {"reward", asJson(f.finalReward)}}},
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
  return {{"title", findings.plan.title},
          {"version", findings.plan.version},
          {"seed", findings.plan.seed},
          {"paired", findings.plan.paired},
          {"complete", findings.complete},
          {"found", findings.found},
          {"conditions", list}};
}

std::string findingsAsTable(const Findings& findings) {
  std::vector<std::string> changes;
  std::size_t width = 12, ofChanges = 24;
  for (const Finding& f : findings.conditions) {
    changes.push_back(f.comparison                         ? changeText(*f.comparison, 1)
                      : isReference(findings.plan, f.name) ? "reference"
                                                           : "");
    width = std::max(width, shownLength(f.name));
    ofChanges = std::max(ofChanges, shownLength(changes.back()));
  }
  std::string out = findings.plan.title.empty() ? "" : findings.plan.title + "\n";
  out += fixedTable(findings, width);
  out += fmt::format("\nup to the end of learning\n{} {} {} {} {} {}\n", padded("", width), padded("end, episode", 20),
                     padded("falls", 16), padded("minutes", 13), padded("change, % (95 %)", ofChanges), "p");
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const Finding& f = findings.conditions[i];
    const auto& c = f.comparison;
    out += fmt::format("{} {} {} {} {} {}{}\n", padded(f.name, width), padded(endText(f), 20),
                       padded(plusMinusText(f.falls, 1), 16), padded(plusMinusText(f.minutes, 2), 13),
                       padded(changes[i], ofChanges), c ? pText(c->p()) : "", c && c->significant() ? " X" : "");
  }
  out += spreadTable(findings, width);
  for (const Finding& f : findings.conditions)
    if (f.comparison && f.comparison->counts) {
      const CountRatio& r = *f.comparison->counts;
      out +=
          fmt::format("{}: as counts at the fixed moment {:.2f} times the reference's falls ({:.2f} … {:.2f}), p {}.\n",
                      f.name, r.ratio.value, r.ratio.low, r.ratio.high, pText(r.p));
    }
  for (const Finding& f : findings.conditions)
    for (const std::string& warning : f.warnings) out += fmt::format("{}: {}.\n", f.name, warning);
  for (const std::string& sentence : findings.found) out += sentence + ".\n";
  if (!findings.plan.growth.empty())
    out +=
        "How many lives there are was decided by what they showed; the sentences above count that, the tables do "
        "not.\n";
  if (!findings.complete) out += "Not all planned lives are there.\n";
  return out;
}

}  // namespace surefoot
