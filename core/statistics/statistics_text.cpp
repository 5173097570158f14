// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/statistics/statistics_text.h"

#include <fmt/format.h>

#include <cmath>

namespace surefoot {

std::string changeText(const Interval& i, int decimals) {
  if (!std::isfinite(i.value)) return "";
  std::string text = signedText(i.value, decimals);
  if (i.known()) text += fmt::format(" ({} … {})", signedText(i.low, decimals), signedText(i.high, decimals));
  return text;
}

int decimalsOf(double value) {
  return std::abs(value) >= 100 ? 0 : std::abs(value) >= 10 ? 1 : 2;
}

std::string plusMinusText(const Interval& i, int decimals) {
  if (!std::isfinite(i.value)) return "–";
  if (!i.known()) return fmt::format("{:.{}f}", i.value, decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", i.value, decimals, (i.high - i.low) / 2, decimals);
}

std::string signedText(double value, int decimals) {
  const std::string text = fmt::format("{:+.{}f}", value, decimals);
  return text.find_first_of("123456789n") == std::string::npos ? text.substr(1) : text;  // n: inf and nan
}

std::string numberCell(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "";
}

nlohmann::ordered_json numberAsJson(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string shortPText(double p) {
  if (std::isnan(p)) return "–";
  return p < 1e-10 ? "< 1e-10" : fmt::format("{:.2g}", p);
}

}  // namespace surefoot
