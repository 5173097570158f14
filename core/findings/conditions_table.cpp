// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/conditions_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/statistics/statistics_text.h"

namespace surefoot {

namespace {

/// "28 of 30", for a measure that is 0 or 1: mean ± would mislead.
std::string countText(const std::vector<double>& values) {
  const auto finite = std::count_if(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  return finite == 0 ? "–" : fmt::format("{} of {}", std::count(values.begin(), values.end(), 1.0), finite);
}

std::string cellOf(const Evidence& e, const std::string& measure) {
  if (measure == "walks") return countText(valuesOf(e, measure));
  const Interval mean = meanOf(e, measure);
  return plusMinusText(mean, decimalsOf(mean.value));
}

std::string pText(const Comparison& c) {
  return shortPText(c.p()) + (c.significant() ? " X" : "");
}

/// "3.7": a share in per cent.
std::string percentText(double share) {
  return std::isfinite(share) ? fmt::format("{:.{}f}", 100 * share, share < 0.0995 ? 1 : 0) : "–";
}

/// The last fixed moment that all conditions came to; empty: none.
std::string fixedMoment(const std::vector<Evidence>& evidence) {
  for (const char* measure : kFixedMeasures)
    if (std::all_of(evidence.begin(), evidence.end(),
                    [&](const Evidence& e) { return std::isfinite(estimateOf(e, measure).value); }))
      return measure;
  return "";
}

}  // namespace

// What does not depend on when learning ended stands first.
ConditionsTable conditionsTable(const Findings& findings, const std::vector<Evidence>& evidence,
                                const std::vector<std::string>& measures) {
  const auto any = [&](const char* measure) {
    return std::any_of(evidence.begin(), evidence.end(),
                       [&](const Evidence& e) { return std::isfinite(estimateOf(e, measure).value); });
  };
  const bool exploring = any("exploring"), greedy = any("final_falls");
  const std::string fixed = fixedMoment(evidence);
  std::vector<std::string> more;
  for (const std::string& measure : measures)
    if (measure != fixed && measure != "exploring" && measure != "final_falls") more.push_back(measure);

  ConditionsTable table{.heads = {"condition", "lives"}, .rows = {}};
  const auto head = [&](bool shown, const std::string& text) {
    if (shown) table.heads.push_back(text);
  };
  head(exploring, "explored, %");
  head(!fixed.empty(), measureTitle(fixed, evidence));
  head(!fixed.empty(), "change, % (95 %)");
  for (const char* text : {"falls during learning", "change, % (95 %)", "p"}) head(true, text);
  head(greedy, "greedy episodes that fall at the end, %");
  for (const std::string& measure : more) head(true, measureTitle(measure, evidence));
  for (std::size_t i = 0; i < findings.conditions.size(); ++i) {
    const Finding& f = findings.conditions[i];
    const auto& c = f.comparison;
    auto& row = table.rows.emplace_back(std::vector{f.name, std::to_string(f.lives)});
    if (exploring) row.push_back(percentText(f.exploring.value));
    if (!fixed.empty()) {
      row.push_back(cellOf(evidence[i], fixed));
      row.push_back(c && c->fixed && c->fixed->measure == fixed ? changeText(c->fixed->change, 0) : "");
    }
    row.push_back(cellOf(evidence[i], "falls") + (f.end ? "" : ", cut off"));
    row.push_back(c ? changeText(*c, 0) : "");
    row.push_back(c ? pText(*c) : "");
    if (greedy) row.push_back(percentText(f.finalFalls.value));
    for (const std::string& measure : more) row.push_back(cellOf(evidence[i], measure));
  }
  return table;
}

}  // namespace surefoot
