// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/language/declared_texts.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "app/manual/known.h"
#include "core/environment_library.h"
#include "core/experiment/configuration.h"
#include "core/findings/evidence.h"
#include "core/formulas.h"
#include "core/glossary.h"
#include "core/handbook/declared_pages.h"
#include "core/lessons/reading/lesson_library.h"
#include "core/life/life_measures.h"
#include "core/life/rule_of_thumb.h"
#include "core/signals/signal_table.h"

namespace surefoot {

namespace {

/// What stands in no list of the core: labels in pictures, axes of figures, kinds of a lesson's steps, what an
/// inspection says of a robot, why there is no rule of thumb.
constexpr const char* kOthers[] = {"Handbook",
                                   "fall",
                                   "start",
                                   "goal",
                                   "cliff",
                                   "balanced",
                                   "stance, near leg",
                                   "stance, far leg",
                                   "left foot",
                                   "right foot",
                                   "left heel",
                                   "left toe",
                                   "right heel",
                                   "right toe",
                                   "voltage",
                                   "action",
                                   "probability",
                                   "value",
                                   "episodes",
                                   "falls",
                                   "falls so far",
                                   "average reward",
                                   "change in 250 episodes",
                                   "share of lives",
                                   "falls during learning",
                                   "simulated time [min]",
                                   "work out",
                                   "find the mistake",
                                   "choose, because",
                                   "choose",
                                   "order",
                                   "point",
                                   "own words",
                                   "predict",
                                   "puzzle",
                                   "task",
                                   "watch",
                                   "try",
                                   "compare",
                                   "the whole range",
                                   "step limit",
                                   "no ending is a fall",
                                   "never falls: nothing to avoid",
                                   "falls at once: hardly anything to learn from",
                                   "falls soon, but not at once: it can learn",
                                   "its program does not answer",
                                   "speed",
                                   "The rule of thumb needs a learning rule that discounts.",
                                   "The rule of thumb appears with the first success.",
                                   "The rule of thumb appears with the first footstep.",
                                   "The rule of thumb is not defined for this task: nothing is earned at a goal."};

class Collector {
 public:
  void add(std::string text) {
    if (text.starts_with("Centres per ")) return;  // said by a pattern
    for (const char* head : {"Q⁺ ", "Q⁻ ", "V ", "ρ ", "reward: "})
      if (text.starts_with(head)) text.erase(0, std::string_view(head).size());
    for (const char* tail : {", from", ", to", ", width"})
      if (text.ends_with(tail)) text.resize(text.size() - std::string_view(tail).size());
    if (std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c); })) texts.insert(text);
  }
  /// A formula in which there are words besides the functions'.
  void addFormula(const std::string& text) {
    static const std::regex kFunction("\\b(sin|cos|exp|min|max|hash|mod|sign)\\b"), kWord("[a-z]{3,}");
    if (std::regex_search(std::regex_replace(text, kFunction, ""), kWord)) texts.insert(text);
  }
  void add(const Named& entry) {
    add(entry.title);
    add(entry.help);
  }
  void add(const Parameter& p) {
    add(p.title);
    add(p.label);
    add(p.help);
    if (!p.origin.starts_with("thesis")) add(p.origin);  // sourceText() writes citations
    for (const std::string& choice : p.choices) add(choice);
    addFormula(formulaOf(p));
  }
  void add(const Environment& environment) {
    const Task& task = environment.task();
    for (const Signal& s : signalsOf(environment, true)) {
      add(s.title);
      add(s.group);
    }
    add(task.actionTitle);
    for (const std::string& name : task.actionNames) add(name);
    for (const ActionVariable& v : task.actionVariables)
      if (v.title.ends_with(" voltage")) add(v.title.substr(0, v.title.size() - 8));
    for (const LifeMeasure& m : lifeMeasures(task.measures)) {
      add(m.title);
      add(m.titleWithUnit());
      add(static_cast<char>(std::toupper(static_cast<unsigned char>(m.title[0]))) + m.title.substr(1));
    }
  }
  std::set<std::string> texts;
};

}  // namespace

std::set<std::string> declaredTexts(const Registry& given, const std::string& robots) {
  Registry registry = given;
  registry.files->setShelf(robots);
  Collector all;
  for (const char* text : kOthers) all.add(text);
  for (const Word& word : glossary()) {
    all.add(word.title);
    all.add(word.text);
    all.addFormula(word.formula);
  }
  for (const auto& entry : registry.features) all.add(entry);
  for (const auto& entry : registry.agents) all.add(entry);
  for (const auto& entry : registry.policies) all.add(entry);
  for (const auto& entry : registry.presets) all.add(entry);
  for (const auto& entry : registry.scenarios) all.add(entry);
  for (const EnvironmentEntry& robot : shelvedRobots(registry)) all.add(robot);
  for (const EnvironmentEntry& entry : registry.environments) {
    all.add(entry);
    if (const auto environment = entry.make()) all.add(*environment);
    for (const AgentEntry& agent : registry.agents)
      for (const FeatureEntry& features : registry.features) {
        const auto c =
            configure(registry, {.environment = entry.name, .agent = agent.name, .features = features.name}, {});
        if (!c) continue;
        for (const auto& one : c->parameters.all()) all.add(one.parameter);
      }
  }
  const Parameters parameters = everyParameter(registry);
  for (const auto& one : parameters.all()) all.add(one.parameter);
  const HandbookSpeech recording = {.declared = [&](const std::string& text) { return all.add(text), text; },
                                    .formula = [&](const std::string& text) { return all.addFormula(text), text; }};
  for (const char* section : handbookSections()) all.add(section);
  for (const auto& pages : {methodPages, worldPages, parameterPages}) static_cast<void>(pages(registry, recording));
  const std::vector<Evidence> none;
  for (const std::string& name : measureNames(std::vector<TaskMeasure>())) all.add(measureTitle(name, none));
  return all.texts;
}

std::set<std::string> lessonTexts(const Registry& registry, const std::string& lessons) {
  std::set<std::string> all;
  static_cast<void>(lessonsIn(registry, lessons, [&](const std::string& text) { return all.insert(text), text; }));
  return all;
}

}  // namespace surefoot
