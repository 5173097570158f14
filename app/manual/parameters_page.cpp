// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <set>

#include "app/manual/known.h"
#include "app/manual/man_page.h"
#include "app/manual/man_pages.h"
#include "core/formulas.h"
#include "core/glossary.h"
#include "core/recipes/figure.h"

namespace surefoot {

namespace {

template <class Entry>
void addNames(ManPage& page, const char* heading, const char* option, const std::vector<Entry>& entries) {
  page.heading(heading);
  page.paragraph(option);
  for (const Entry& entry : entries) {
    page.term(entry.name, "", entry.help.empty() ? entry.title + "." : entry.help);
    const Word* word = wordOf(entry.name);
    if (word && !word->formula.empty()) page.below(word->formula);
    if (word) page.below(fmt::format("{} ({})", word->text, word->source));
  }
}

void addParameter(ManPage& page, const Parameter& p) {
  const std::string unit = p.unit.empty() ? "" : " " + p.unit;
  page.term(p.key, p.symbol, fmt::format("{}. {}", p.title, p.help));
  page.below(formulaOf(p));
  page.below(fmt::format("Usual: {}{} ({}). Allowed: {}. Applies: {}.", formatValue(p, p.fallback), unit, p.origin,
                         rangeText(p), whenName(p.when)));
}

/// By the first word of their keys.
void addParameters(ManPage& page, const Parameters& parameters) {
  page.heading("Parameters");
  page.paragraph("--set KEY=VALUE");
  const auto groupOf = [](const Parameters::Entry& e) { return e.parameter.key.substr(0, e.parameter.key.find('.')); };
  std::set<std::string> groups;
  for (const auto& entry : parameters.all()) groups.insert(groupOf(entry));
  for (const std::string& group : groups) {
    page.subheading(group);
    for (const auto& entry : parameters.all())
      if (groupOf(entry) == group) addParameter(page, entry.parameter);
  }
}

}  // namespace

ManualFile parametersPage(const Registry& registry, const std::string& date) {
  ManPage page("surefoot-parameters", 7, date, "everything that can be chosen by name or set");
  page.heading("Description");
  page.paragraph(
      "These are the names and parameters of surefoot-train(1), surefoot-window(1) and of plans. `surefoot list` says "
      "the "
      "same, and `surefoot list ROBOT` what a robot from a file has.");
  addNames(page, "Environments", "--environment NAME", registry.environments);
  addNames(page, "Robots from files", "--environment NAME", shelvedRobots(registry));
  addNames(page, "Features", "--features NAME", registry.features);
  addNames(page, "Agents", "--agent NAME", registry.agents);
  addNames(page, "Policies", "--policy NAME", registry.policies);
  addNames(page, "Presets", "--preset NAME", registry.presets);
  addNames(page, "Scenarios", "--scenario NAME", registry.scenarios);
  page.heading("Figures of plans");
  page.paragraph("kind = NAME");
  for (const FigureKind& kind : figureKinds()) page.term(kind.name, "", kind.shows);
  addParameters(page, everyParameter(registry));
  page.heading("See also");
  page.paragraph("surefoot(1), surefoot-list(1), surefoot-train(1), surefoot-window(1)");
  return {"surefoot-parameters.7", page.text()};
}

}  // namespace surefoot
