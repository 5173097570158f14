// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/strides_report.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

namespace {

struct StrideMeasure {
  const char *key, *title, *unit;
  double (*of)(const Stride&);
};
constexpr StrideMeasure kStrideMeasures[] = {
    {"length", "stride length", "m", [](const Stride& s) { return s.length; }},
    {"duration", "stride duration", "s", [](const Stride& s) { return s.duration; }},
    {"speed", "stride speed", "m/s", [](const Stride& s) { return s.speed(); }},
    {"energy", "energy of a stride", "J", [](const Stride& s) { return s.energy; }},
    {"energy_a_metre", "energy a metre", "J/m", [](const Stride& s) { return s.perMetre(); }},
    {"both_down", "both feet down", "", [](const Stride& s) { return s.bothDown; }},
};

Spread spreadOfAll(const std::vector<Stride>& strides, const StrideMeasure& measure) {
  std::vector<double> values;
  for (const Stride& stride : strides) values.push_back(measure.of(stride));
  return spreadOf(values);
}

nlohmann::ordered_json orNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

}  // namespace

nlohmann::ordered_json asJson(const std::vector<Stride>& strides) {
  if (strides.empty()) return nullptr;
  nlohmann::ordered_json json = {{"count", strides.size()}};
  for (const StrideMeasure& measure : kStrideMeasures) {
    const Spread spread = spreadOfAll(strides, measure);
    json[measure.key] = {{"mean", orNull(spread.mean)}, {"deviation", orNull(spread.deviation)}};
  }
  return json;
}

std::string asLines(const std::vector<Stride>& strides) {
  if (strides.empty()) return {};
  std::string text = fmt::format("{:<24}{}\n", "strides", strides.size());
  for (const StrideMeasure& measure : kStrideMeasures) {
    const Spread spread = spreadOfAll(strides, measure);
    if (!std::isfinite(spread.mean)) continue;
    text += fmt::format("{:<24}{:.3g}", measure.title, spread.mean);
    if (std::isfinite(spread.deviation)) text += fmt::format(" ± {:.2g}", spread.deviation);
    text += fmt::format("{}{}\n", *measure.unit ? " " : "", measure.unit);
  }
  return text;
}

}  // namespace surefoot
