// SPDX-License-Identifier: GPL-3.0-or-later
// Findings as tables for other programs.
#include <fmt/format.h>

#include <cmath>

#include "core/laboratory/findings.h"
#include "core/text.h"

namespace surefoot {

namespace {

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// Letters that LaTeX takes for commands.
std::string latex(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("&%$#_{}").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string findingsAsCsv(const Findings& findings) {
  std::string csv =
      "condition,reference,lives,end,falls,falls_low,falls_high,minutes,minutes_low,minutes_high,change,change_low,"
      "change_high,p,p_holm,significant\n";
  for (const Finding& f : findings.conditions) {
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}", csvCell(f.name), csvCell(f.reference), f.lives,
                       f.end ? std::to_string(*f.end) : "", number(f.falls.value), number(f.falls.low),
                       number(f.falls.high), number(f.minutes.value), number(f.minutes.low), number(f.minutes.high));
    if (const auto& c = f.comparison)
      csv += fmt::format(",{},{},{},{:.6g},{:.6g},{}\n", number(c->change.value), number(c->change.low),
                         number(c->change.high), c->p(), c->holm, c->significant() ? 1 : 0);
    else
      csv += ",,,,,,\n";
  }
  return csv;
}

std::string findingsAsLatex(const Findings& findings) {
  std::string out =
      "\\begin{tabular}{lrrrrl}\n\\hline\nCondition & Lives & Falls & Change [\\%] & $p$ & \\\\\n\\hline\n";
  for (const Finding& f : findings.conditions) {
    out += fmt::format("{} & {} & ${:.1f} \\pm {:.1f}$ & ", latex(f.name), f.lives, f.falls.value,
                       (f.falls.high - f.falls.low) / 2);
    if (const auto& c = f.comparison)
      out += fmt::format("${:+.1f}$ (${:+.1f}$ \\dots\\ ${:+.1f}$) & {:.2g} & {} \\\\\n", c->change.value,
                         c->change.low, c->change.high, c->p(), c->significant() ? "X" : "");
    else
      out += "& & \\\\\n";
  }
  return out + "\\hline\n\\end{tabular}\n";
}

}  // namespace surefoot
