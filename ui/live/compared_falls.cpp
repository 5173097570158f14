// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live/compared_falls.h"

#include <algorithm>
#include <cmath>

namespace surefoot {

namespace {

using Position = std::int64_t CurvePoint::*;

/// Falls up to a position; between two points of a thinned-out curve they are taken to be spread evenly.
std::int64_t fallsAt(const RunCurve& curve, Position position, std::int64_t at) {
  const auto& points = curve.points;
  const auto after = std::upper_bound(points.begin(), points.end(), at,
                                      [&](std::int64_t value, const CurvePoint& p) { return value < p.*position; });
  if (after == points.begin()) return 0;
  const CurvePoint& before = *(after - 1);
  const bool between = after != points.end() && after->episode > before.episode + 1;
  if (!between || before.*position == at) return before.falls;
  const double share =
      static_cast<double>(at - before.*position) / static_cast<double>((*after).*position - before.*position);
  return before.falls + std::llround(std::floor(share * static_cast<double>(after->falls - before.falls)));
}

std::optional<ComparedFalls> compared(const RunCurve& first, const RunCurve& second, Position position) {
  if (first.points.empty() || second.points.empty()) return std::nullopt;
  const std::int64_t at = std::min(first.points.back().*position, second.points.back().*position);
  return ComparedFalls{at, fallsAt(first, position, at), fallsAt(second, position, at)};
}

}  // namespace

std::optional<ComparedFalls> fallsAtEqualEpisodes(const RunCurve& first, const RunCurve& second) {
  return compared(first, second, &CurvePoint::episode);
}

std::optional<ComparedFalls> fallsAtEqualSteps(const RunCurve& first, const RunCurve& second) {
  return compared(first, second, &CurvePoint::lifeSteps);
}

}  // namespace surefoot
