// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/thesis_marks.h"

#include <cmath>

#include "core/laboratory/statistics.h"

namespace surefoot {

namespace {

/// What a claim's reduction is a share of: the mean of the claim's reference, or of the condition's own.
std::optional<double> referenceMean(const Claim& claim, const std::string& condition, const std::string& measure,
                                    const std::vector<Evidence>& evidence) {
  std::string reference = claim.arguments.value("reference", "");
  for (const Evidence& e : evidence)
    if (reference.empty() && e.name() == condition) reference = e.record.condition.reference;
  for (const Evidence& e : evidence)
    if (e.name() == reference && !e.lives.empty()) return meanOf(valuesOf(e, measure));
  return std::nullopt;
}

bool isAbout(const Claim& claim, const std::string& condition, const std::string& measure) {
  if (claim.kind != "value" && claim.kind != "reduction") return false;
  if (!claim.arguments.contains("thesis") || !claim.arguments["thesis"].is_number()) return false;
  if (claim.arguments.value("measure", "falls") != measure) return false;
  for (const auto& pattern : claim.arguments.value("conditions", std::vector<std::string>()))
    if (fits(condition, pattern)) return true;
  return false;
}

}  // namespace

void markThesis(Figure& figure, const std::string& measure, const std::vector<Claim>& claims,
                const std::vector<Evidence>& evidence) {
  if (!figure.bars) return;
  for (FigureSeries& series : figure.series)
    for (const Claim& claim : claims) {
      if (!isAbout(claim, series.name, measure)) continue;
      const double thesis = claim.arguments["thesis"].get<double>();
      if (claim.kind == "value")
        series.thesis = thesis;
      else if (const auto mean = referenceMean(claim, series.name, measure, evidence); mean && std::isfinite(*mean))
        series.thesis = *mean * (1 + thesis / 100);
    }
}

}  // namespace surefoot
