// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "app/reports/progress_line.h"
#include "app/reports/report_table.h"
#include "app/reports/reproduction.h"
#include "core/basics/typed_json.h"
#include "core/basics/version.h"
#include "core/files/read_file.h"
#include "core/files/whole_file.h"
#include "core/statistics/statistics_text.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// A claim as a row of the table.
struct Row {
  const Judgement* judgement;
  std::string recipe, preset;
};

std::vector<Row> rowsOf(std::span<const Reproduced> recipes) {
  std::vector<Row> rows;
  for (const Reproduced& r : recipes) {
    for (const Judgement& j : r.judgements) rows.push_back({&j, r.name, r.preset});
    for (const Judgement& j : r.onLabPreset) rows.push_back({&j, r.name, "lab"});
  }
  const auto place = [](const std::string& id) {
    return std::pair(id.substr(0, 1), std::atoi(id.c_str() + std::min<std::size_t>(1, id.size())));
  };
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const Row& a, const Row& b) { return place(a.judgement->id) < place(b.judgement->id); });
  return rows;
}

std::string numberText(double v) {
  return fmt::format("{:.{}f}", v, decimalsOf(v));
}
/// "-45, p 1.4e-05"
std::string thesisText(const Judgement& j) {
  const std::string p = j.thesisP ? ", p " + shortPText(*j.thesisP) : "";
  if (j.thesis.is_number()) return fmt::format("{:g}", j.thesis.get<double>()) + p;
  return j.thesis.is_string() ? j.thesis.get<std::string>() : "";
}
std::string oursText(const Judgement& j) {
  if (!j.ours) return "";
  std::string text = numberText(*j.ours);
  if (j.low && j.high) text += fmt::format(" ({} … {})", numberText(*j.low), numberText(*j.high));
  return text;
}
std::string pText(const Judgement& j) {
  return j.p ? shortPText(*j.p) : "";
}

std::string summary(const std::vector<Row>& rows) {
  std::map<std::string, std::array<int, 3>> counts;
  for (const Row& r : rows) ++counts[r.judgement->counts][static_cast<std::size_t>(r.judgement->verdict)];
  const auto& tests = counts["test"];
  std::string text =
      fmt::format("{} judgements could have failed: {} agree with the thesis, {} differ, {} are undecided.",
                  tests[0] + tests[1] + tests[2], tests[0], tests[1], tests[2]);
  constexpr std::pair<const char*, const char*> kOthers[] = {
      {"fitted", "numbers that the default preset was fitted to, which is no evidence"},
      {"arithmetic", "arithmetic"},
      {"implied", "numbers that the thesis implies and does not print"},
      {"question", "questions that the thesis leaves open"}};
  for (const auto& [name, what] : kOthers)
    if (const auto& c = counts[name]; c[0] + c[1] + c[2] > 0)
      text += fmt::format(" Apart from them: {} ({} agree, {} differ, {} undecided).", what, c[0], c[1], c[2]);
  return text;
}

/// "36 conditions, 40 lives each, 1:20, content 0123…"
std::string extentOf(const Reproduced& r) {
  std::string text =
      fmt::format("{} condition{}, {} {}{}, {}", r.conditions, r.conditions == 1 ? "" : "s", r.lives,
                  r.lives == 1 ? "life" : "lives", r.conditions == 1 ? "" : " each", durationText(r.seconds));
  if (!r.content.empty()) text += fmt::format(", content {}", r.content);
  if (!r.labContent.empty()) text += fmt::format(", on the lab preset {}", r.labContent);
  return text;
}

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (int k = 0; k < 4; ++k)
      out += i + static_cast<std::size_t>(k) > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
  }
  return out;
}

constexpr const char* kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;color:#1c1c1e;max-width:1080px;margin:2em auto;padding:0 1.2em}"
    "h1{font-size:1.6em}h2{font-size:1.2em;margin-top:2.2em;border-top:1px solid #ddd;padding-top:.8em}"
    "table{border-collapse:collapse;font-size:13px;width:100%;margin:.8em "
    "0}th,td{text-align:left;vertical-align:top;padding:4px "
    "8px;border-bottom:1px solid #e4e4e4}"
    "th{font-weight:600}td.n{white-space:nowrap}img{max-width:100%;width:760px;border:1px solid #e4e4e4;margin:.6em 0}"
    ".agrees{color:#1a6b3c}.differs{color:#b3261e}.undecided{color:#666}small{color:#666}";

std::string asHtmlTable(const std::vector<Row>& rows) {
  std::string out =
      "<table><tr><th>claim</th><th>what</th><th>thesis</th><th>ours (95 %)</th><th>p</th><th>verdict</th></tr>\n";
  for (const Row& r : rows) {
    const Judgement& j = *r.judgement;
    out += fmt::format(
        "<tr><td class=n>{}{}</td><td>{}{}</td><td>{}</td><td class=n>{}</td><td class=n>{}</td><td "
        "class={}>{}</td></tr>\n",
        j.id, r.preset == "lab" ? "<br><small>lab preset</small>" : "", escapedForHtml(j.says),
        j.note.empty() ? "" : "<br><small>" + escapedForHtml(j.note) + "</small>", escapedForHtml(thesisText(j)),
        oursText(j), escapedForHtml(pText(j)), nameOf(j.verdict), nameOf(j.verdict));
  }
  return out + "</table>\n";
}

Result<std::string> asHtml(const std::vector<Reproduced>& recipes, const std::string& folder, bool pictures) {
  const auto all = rowsOf(recipes);
  std::string out = fmt::format(
      "<!doctype html><html lang=en><meta charset=utf-8><title>Surefoot: reproduction</title><style>{}</style>\n"
      "<h1>Avoiding failure states during reinforcement learning: a reproduction</h1>\n<p>{} Surefoot {}.</p>\n",
      kStyle, summary(all), kVersion);
  if (!pictures)
    out += "<p>There are no pictures: this program was built without Qt. The numbers are in the CSV files.</p>\n";
  for (const Reproduced& r : recipes) {
    out += fmt::format("<h2 id=\"{0}\">{0}: {1}</h2>\n<p><small>{2}</small></p>\n", escapedForHtml(r.name),
                       escapedForHtml(r.title), extentOf(r));
    for (std::size_t i = 0; pictures && i < r.figures.size(); ++i) {
      const auto png = readFile(folder + "/" + r.figures[i] + ".png");
      if (!png) return png.error();
      out += fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">\n", escapedForHtml(r.captions[i]),
                         base64(*png));
    }
    if (!r.table.rows.empty()) out += asHtml(r.table);
    if (const auto rows = rowsOf({&r, 1}); !rows.empty()) out += asHtmlTable(rows);
  }
  return out + "<h2>All claims</h2>\n" + asHtmlTable(all) + "</html>\n";
}

std::string asMarkdownTable(const std::vector<Row>& rows) {
  std::string out = "| claim | what | thesis | ours (95 %) | p | verdict | note |\n|---|---|---|---|---|---|---|\n";
  for (const Row& r : rows) {
    const Judgement& j = *r.judgement;
    out += fmt::format("| {}{} | {} | {} | {} | {} | {} | {} |\n", j.id, r.preset == "lab" ? " (lab)" : "",
                       escapedForMarkdown(j.says), escapedForMarkdown(thesisText(j)), oursText(j), pText(j),
                       nameOf(j.verdict), escapedForMarkdown(j.note));
  }
  return out;
}

std::string asMarkdown(const std::vector<Reproduced>& recipes, bool pictures) {
  const auto all = rowsOf(recipes);
  std::string out =
      fmt::format("# Avoiding failure states during reinforcement learning: a reproduction\n\n{} Surefoot {}.\n",
                  summary(all), kVersion);
  for (const Reproduced& r : recipes) {
    out += fmt::format("\n## {}: {}\n\n{}.\n\n", r.name, r.title, extentOf(r));
    for (std::size_t i = 0; pictures && i < r.figures.size(); ++i)
      out += fmt::format("![{}]({}.png)\n", r.captions[i], r.figures[i]);
    if (!r.table.rows.empty()) out += "\n" + asMarkdown(r.table);
    if (const auto rows = rowsOf({&r, 1}); !rows.empty()) out += "\n" + asMarkdownTable(rows);
  }
  return out + "\n## All claims\n\n" + asMarkdownTable(all);
}

}  // namespace

std::string claimsAsJson(const std::vector<Reproduced>& recipes) {
  OrderedJson list = OrderedJson::array();
  for (const Row& r : rowsOf(recipes)) {
    OrderedJson claim = judgementAsJson(*r.judgement);
    claim["recipe"] = r.recipe;
    claim["preset"] = r.preset;
    list.push_back(std::move(claim));
  }
  return jsonText(list, 2) + "\n";
}

Status checkReportPlace(const std::string& folder) {
  for (const char* name : {"report.html", "report.md"}) {
    const std::string path = folder + "/" + name;
    const auto head = readHead(path, 4096);
    if (head && head->find("Surefoot") == std::string::npos)
      return Error{fmt::format("--out: {} exists already and is no report of Surefoot; name another folder.", path),
                   ErrorKind::File};
  }
  return Done{};
}

Status writeReport(const std::vector<Reproduced>& recipes, const std::string& folder, bool pictures) {
  const auto html = asHtml(recipes, folder, pictures);
  if (!html) return html.error();
  if (const Status s = writeWhole("--out", folder + "/report.html", *html); !s) return s;
  if (const Status s = writeWhole("--out", folder + "/report.md", asMarkdown(recipes, pictures)); !s) return s;
  return writeWhole("--out", folder + "/claims.json", claimsAsJson(recipes));
}

}  // namespace surefoot
