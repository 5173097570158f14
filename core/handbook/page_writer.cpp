// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/page_writer.h"

#include "core/formulas.h"
#include "core/glossary.h"
#include "core/text/number_text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

const char* whenText(When when) {
  switch (when) {
    case When::Now:
      return "Holds at once.";
    case When::NextEpisode:
      return "Holds from the next episode on.";
    case When::NewTable:
      break;
  }
  return "Begins another life: the table is made anew.";
}

}  // namespace

std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|&").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string PageWriter::list(const std::vector<std::string>& texts, const std::string& last) const {
  std::vector<std::string> all;
  for (const std::string& text : texts) all.push_back(said(text));
  return joinWords(all, said(last));
}

std::string PageWriter::bound(double value) const {
  return translated(speech_.number, boundText(value));
}

std::string PageWriter::meaning(std::string_view name) const {
  const Word* word = wordOf(name);
  if (!word) return "";
  std::string text = said(word->text) + "\n\n";
  if (!word->formula.empty()) text += fmt::format("> {}\n\n", plain(translated(speech_.formula, word->formula)));
  if (!word->source.empty())
    text += speech_.say("Source: {0}.", plain(translated(speech_.source, word->source))) + "\n\n";
  return text;
}

std::string PageWriter::paragraph(const Parameters::Entry& entry) const {
  const Parameter& p = entry.parameter;
  const std::string unit = p.unit.empty() ? "" : " " + plain(p.unit), usual = formatValue(p, p.fallback);
  std::string text = fmt::format("### <a name=\"{}\"></a>{}{}\n\n`{}`, ", p.key, said(p.title),
                                 p.symbol.empty() ? "" : ", " + plain(p.symbol), p.key);
  text += p.kind == Kind::Choice ? speech_.say("one of {0}; default {1}.", list(p.choices, "or"), said(usual))
                                 : speech_.say("{0} … {1}; default {2}.", bound(p.low), bound(p.high) + unit,
                                               plain(translated(speech_.number, usual)) + unit);
  text += fmt::format(" {}\n\n{}", said(whenText(p.when)), said(p.help));
  if (!p.origin.empty())
    text += " " + speech_.say("The default is from: {0}.", plain(translated(speech_.source, p.origin)));
  if (!p.needs.empty()) text += " " + speech_.say("Has an effect only with {0}.", fmt::format("`{}`", p.needs));
  if (const std::string formula = formulaOf(p); !formula.empty())
    text += fmt::format("\n\n> {}", plain(translated(speech_.formula, formula)));
  return text + "\n\n";
}

}  // namespace surefoot
