// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recipes/thesis_marks.h"

#include <cmath>

#include "core/basics/typed_json.h"
#include "core/statistics/statistics.h"

namespace surefoot {

namespace {

/// The mean to which a claim's reduction is relative: of the claim's reference, or of the condition's own.
std::optional<double> referenceMean(const Claim& claim, const std::string& condition, const std::string& measure,
                                    const std::vector<Evidence>& evidence) {
  std::string reference = textIn(claim.arguments, "reference");
  for (const Evidence& e : evidence)
    if (reference.empty() && e.name() == condition) reference = e.record.condition.reference;
  for (const Evidence& e : evidence)
    if (e.name() == reference && !e.lives.empty()) return meanOf(valuesOf(e, measure));
  return std::nullopt;
}

/// The number that a claim about this measure gives for a condition.
std::optional<double> thesisOn(const Claim& claim, const std::string& condition, const std::string& measure) {
  const double thesis = numberIn(claim.arguments, "thesis");
  const bool kind = claim.kind == "value" || claim.kind == "reduction";
  if (!kind || !std::isfinite(thesis) || textIn(claim.arguments, "measure", "falls") != measure) return std::nullopt;
  return isAbout(claim, condition) ? std::optional(thesis) : std::nullopt;
}

}  // namespace

void markThesis(Figure& figure, const std::string& measure, const std::vector<Claim>& claims,
                const std::vector<Evidence>& evidence) {
  if (!figure.bars) return;
  for (FigureSeries& series : figure.series)
    for (const Claim& claim : claims) {
      const auto thesis = thesisOn(claim, series.name, measure);
      if (!thesis) continue;
      if (claim.kind == "value")
        series.thesis = *thesis;
      else if (const auto mean = referenceMean(claim, series.name, measure, evidence); mean && std::isfinite(*mean))
        series.thesis = *mean * (1 + *thesis / 100);
    }
}

}  // namespace surefoot
