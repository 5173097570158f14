// SPDX-License-Identifier: GPL-3.0-or-later
// Findings as tables for other programs.
#include <fmt/format.h>

#include <cmath>

#include "core/findings/findings.h"
#include "core/statistics/statistics_text.h"
#include "core/text/latex.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

std::string number(double value) {
  constexpr int kDigits = 6;
  return numberCell(value, kDigits);
}

/// An interval as three cells.
std::string numbers(const Interval& i) {
  return fmt::format("{},{},{}", number(i.value), number(i.low), number(i.high));
}

/// "-45.0 (-55.1 … -32.0)" with true signs.
std::string latexOf(const Interval& i, const char* unit) {
  if (!std::isfinite(i.value)) return "--";
  std::string out = fmt::format("${}${}", signedText(i.value, 1), unit);
  if (i.known()) out += fmt::format(" (${}$ \\dots\\ ${}$)", signedText(i.low, 1), signedText(i.high, 1));
  return out;
}

/// "3.1\times 10^{-5}", "<10^{-10}"
std::string latexOfP(double p) {
  if (std::isnan(p)) return "--";
  if (p < 1e-10) return "$<10^{-10}$";
  if (p >= 0.001) return fmt::format("{:.3f}", p);
  const int exponent = static_cast<int>(std::floor(std::log10(p)));
  return fmt::format("${:.1f}\\times 10^{{{}}}$", p / std::pow(10, exponent), exponent);
}

}  // namespace

std::string findingsAsCsv(const Findings& findings) {
  std::string csv =
      "condition,reference,lives,end,falls,falls_low,falls_high,minutes,minutes_low,minutes_high,change,change_low,"
      "change_high,p,p_holm,significant,difference,difference_low,difference_high,end_low,end_high,falls_1_min,"
      "falls_3_min,falls_6_min,falls_330,exploring,final_falls,final_reward,fixed_measure,fixed_change,"
      "fixed_change_low,fixed_change_high,fixed_p\n";
  for (const Finding& f : findings.conditions) {
    csv += fmt::format("{},{},{},{},{},{}", csvCell(f.name), csvCell(f.reference), f.lives,
                       f.end ? std::to_string(*f.end) : "", numbers(f.falls), numbers(f.minutes));
    if (const auto& c = f.comparison)
      csv += fmt::format(",{},{},{},{},{}", numbers(c->change), number(c->p()), number(c->holm),
                         c->ofUnits ? (c->significant() ? "1" : "0") : "", numbers(c->difference));
    else
      csv += ",,,,,,,,,";
    for (const double v :
         {f.endRange.low, f.endRange.high, f.fallsByMinute[0].value, f.fallsByMinute[1].value, f.fallsByMinute[2].value,
          f.fallsByEpisode.value, f.exploring.value, f.finalFalls.value, f.finalReward.value})
      csv += "," + number(v);
    if (const auto& fixed = f.comparison ? f.comparison->fixed : std::optional<FixedChange>())
      csv += fmt::format(",{},{},{}\n", fixed->measure, numbers(fixed->change), number(fixed->p));
    else
      csv += ",,,,,\n";
  }
  return csv;
}

std::string findingsAsLatex(const Findings& findings) {
  std::string out =
      "\\begin{tabular}{lrrrrl}\n\\hline\nCondition & Lives & Falls & Change [\\%] & $p$ & \\\\\n\\hline\n";
  for (const Finding& f : findings.conditions) {
    out += fmt::format("{} & {} & ", latexText(f.name), f.lives);
    if (std::isfinite(f.falls.value)) out += fmt::format("${:.1f}", f.falls.value);
    if (f.falls.known()) out += fmt::format(" \\pm {:.1f}", (f.falls.high - f.falls.low) / 2);
    out += std::isfinite(f.falls.value) ? "$ & " : "-- & ";
    if (const auto& c = f.comparison)
      out += fmt::format("{} & {} & {} \\\\\n",
                         std::isfinite(c->change.value) ? latexOf(c->change, "") : latexOf(c->difference, " falls"),
                         latexOfP(c->p()), c->significant() ? "X" : "");
    else
      out += "& & \\\\\n";
  }
  return out + "\\hline\n\\end{tabular}\n";
}

}  // namespace surefoot
