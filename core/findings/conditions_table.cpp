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

}  // namespace

ConditionsTable conditionsTable(const Findings& findings, const std::vector<Evidence>& evidence,
                                const std::vector<std::string>& measures) {
  ConditionsTable table{.heads = {"condition", "lives", measureTitle("falls", evidence), "change, % (95 %)", "p"},
                        .rows = {}};
  for (const std::string& measure : measures) table.heads.push_back(measureTitle(measure, evidence));
  for (std::size_t i = 0; i < findings.conditions.size(); ++i) {
    const Finding& f = findings.conditions[i];
    const auto& c = f.comparison;
    table.rows.push_back({f.name, std::to_string(f.lives), cellOf(evidence[i], "falls"), c ? changeText(*c, 0) : "",
                          c ? pText(*c) : ""});
    for (const std::string& measure : measures) table.rows.back().push_back(cellOf(evidence[i], measure));
  }
  return table;
}

}  // namespace surefoot
