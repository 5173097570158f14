// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reports/report_table.h"

namespace surefoot {

std::string escapedForHtml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string escapedForMarkdown(std::string text) {
  for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2)) text.insert(i, 1, '\\');
  return text;
}

std::string asHtml(const ConditionsTable& table) {
  std::string out = "<table><tr>";
  for (const std::string& head : table.heads) out += "<th>" + escapedForHtml(head) + "</th>";
  out += "</tr>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (const std::string& cell : row) out += "<td class=n>" + escapedForHtml(cell) + "</td>";
    out += "</tr>\n";
  }
  return out + "</table>\n";
}

std::string asMarkdown(const ConditionsTable& table) {
  std::string out = "|", rule = "|";
  for (const std::string& head : table.heads) {
    out += " " + escapedForMarkdown(head) + " |";
    rule += rule.size() == 1 ? "---|" : "---:|";
  }
  out += "\n" + rule + "\n";
  for (const auto& row : table.rows) {
    out += "|";
    for (const std::string& cell : row) out += " " + escapedForMarkdown(cell) + " |";
    out += "\n";
  }
  return out;
}

}  // namespace surefoot
