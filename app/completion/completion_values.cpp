// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/completion_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/manual/known.h"
#include "app/process/resources.h"
#include "app/requests/open_line.h"
#include "core/environment_library.h"
#include "core/experiment/configuration.h"
#include "core/lessons/reading/lesson_library.h"

namespace surefoot {

namespace {

enum class FileEnding { Toml, Session, Tensors, Journal, Store, Table };
using enum FileEnding;
constexpr const char* kEndings[] = {"toml", "surefoot", "safetensors", "jsonl", "sqlite", "csv"};

using Offer = void (*)(const UnfinishedLine&, Completions&);

template <class Entry>
void offerNames(const std::vector<Entry>& entries, Completions& into) {
  for (const Entry& entry : entries) into.words.push_back({entry.name, entry.title});
}

void offerFiles(Completions& into, std::initializer_list<const char*> endings) {
  into.files = true;
  into.endings.assign(endings.begin(), endings.end());
}

/// What was chosen on the line so far.
Names namesOn(const UnfinishedLine& line) {
  Names names;
  const std::pair<const char*, std::string*> options[] = {
      {"--environment", &names.environment}, {"--preset", &names.preset},
      {"--scenario", &names.scenario},       {"--agent", &names.agent},
      {"--features", &names.features},       {"--policy", &names.policy}};
  for (std::size_t i = 0; i < line.words.size(); ++i)
    for (const auto& [option, name] : options) {
      const std::string with = std::string(option) + "=";
      if (line.words[i] == option && i + 1 < line.words.size()) *name = line.words[i + 1];
      if (line.words[i].starts_with(with)) *name = line.words[i].substr(with.size());
    }
  return names;
}

void offerEnvironments(const UnfinishedLine& line, Completions& into) {
  offerNames(line.registry.environments, into);
  offerNames(shelvedRobots(line.registry), into);
  offerFiles(into, {"toml"});
}

void offerRobots(const UnfinishedLine& line, Completions& into) {
  offerNames(shelvedRobots(line.registry), into);
  offerFiles(into, {"toml"});
}

/// Presets or scenarios: of the environment that was chosen.
template <auto of>
void offerAssignments(const UnfinishedLine& line, Completions& into) {
  const auto name = environmentNamed(line.registry, namesOn(line).environment);
  if (!name) return;
  for (const AssignmentEntry* entry : of(line.registry, *name)) into.words.push_back({entry->name, entry->title});
}

void offerModels(const UnfinishedLine& line, Completions& into) {
  into.words.push_back({"all", "every scenario"});
  offerAssignments<&scenariosOf>(line, into);
}

void offerPolicies(const UnfinishedLine& line, Completions& into) {
  offerNames(line.registry.policies, into);
}

void offerLessons(const UnfinishedLine& line, Completions& into) {
  for (const ShelvedLesson& one : lessonsIn(line.registry, resourceFolder("lessons")))
    if (one.lesson) into.words.push_back({one.lesson->name, one.lesson->title});
  offerFiles(into, {"toml"});
}

void offerKiosks(const UnfinishedLine& line, Completions& into) {
  for (const ShelvedLesson& one : lessonsIn(line.registry, resourceFolder("lessons")))
    if (one.lesson && one.lesson->kiosk) into.words.push_back({one.lesson->name, one.lesson->title});
  offerFiles(into, {"toml"});
}

/// KEY=, of what was chosen; behind it the names of a choice. `before` stands in front of the key.
void offerKeys(const UnfinishedLine& line, const std::string& before, Completions& into) {
  const auto configuration = configure(line.registry, namesOn(line), {});
  const Parameters parameters = configuration ? configuration->parameters : everyParameter(line.registry);
  const std::string written = line.written.substr(before.size());
  const std::string key = written.substr(0, written.find('='));
  for (const auto& entry : parameters.all()) {
    const Parameter& p = entry.parameter;
    if (key == written)
      into.words.push_back(
          {before + p.key + "=", fmt::format("{} [{}], {}", p.title, formatValue(p, entry.value), rangeText(p))});
    else if (key == p.key && p.kind == Kind::Choice)
      for (const std::string& choice : p.choices) into.words.push_back({before + key + "=" + choice, p.title});
  }
}

void offerSettings(const UnfinishedLine& line, Completions& into) {
  offerKeys(line, "", into);
}

/// STEP:KEY=VALUE
void offerMoments(const UnfinishedLine& line, Completions& into) {
  const auto colon = line.written.find(':');
  if (colon == std::string::npos) return;
  const std::string before = line.written.substr(0, colon + 1);
  offerKeys(line, before, into);
  const std::string written = line.written.substr(before.size());
  if (written.starts_with("policy="))
    for (const PolicyEntry& entry : line.registry.policies)
      into.words.push_back({before + "policy=" + entry.name, entry.title});
  if (written.find('=') != std::string::npos) return;
  into.words.push_back({before + "policy=", "another action-selection rule"});
  into.words.push_back({before + "push=", "an impulse [N s]"});
  into.words.push_back({before + "place=", "a state"});
}

void offerRecipes(const UnfinishedLine&, Completions& into) {
  into.words.push_back({"all", "every recipe that does not take long"});
  for (const std::string& name : shippedRecipes()) into.words.push_back({name});
  offerFiles(into, {"toml"});
}

void offerPlans(const UnfinishedLine&, Completions& into) {
  for (const std::string& name : shippedPlans()) into.words.push_back({name});
  offerFiles(into, {"toml"});
}

/// Of `lessons`: what is to be done, then with what.
void offerLessonWords(const UnfinishedLine& line, Completions& into) {
  const auto said = [&](const char* word) {
    return std::find(line.words.begin(), line.words.end(), word) != line.words.end();
  };
  if (said("check")) return offerFiles(into, {"toml"});
  if (said("handout")) return offerLessons(line, into);
  if (said("grade")) return void(into.folders = true);
  into.words.insert(into.words.end(), {{"check", "live through lessons"},
                                       {"grade", "live what students handed in again"},
                                       {"handout", "print a lesson"}});
}

template <FileEnding... endings>
void offerEndings(const UnfinishedLine&, Completions& into) {
  offerFiles(into, {kEndings[static_cast<int>(endings)]...});
}

/// By the option, or by the command and the word that stands alone.
const std::map<std::string, Offer>& offers() {
  static const std::map<std::string, Offer> all = {
      {"--environment", offerEnvironments},
      {"--preset", offerAssignments<&presetsOf>},
      {"--scenario", offerAssignments<&scenariosOf>},
      {"robustness --scenario", offerModels},
      {"--agent", [](const UnfinishedLine& l, Completions& c) { offerNames(l.registry.agents, c); }},
      {"--features", [](const UnfinishedLine& l, Completions& c) { offerNames(l.registry.features, c); }},
      {"--policy", offerPolicies},
      {"--set", offerSettings},
      {"--at", offerMoments},
      {"--lesson", offerLessons},
      {"--kiosk", offerKiosks},
      {"--like", offerRobots},
      {"--page",
       [](const UnfinishedLine&, Completions& c) {
         for (const std::string& name : OpenLine::pages()) c.words.push_back({name});
       }},
      {"--language",
       [](const UnfinishedLine&, Completions& c) {
         for (const std::string& code : OpenLine::languages()) c.words.push_back({code});
       }},
      {"--appearance",
       [](const UnfinishedLine&, Completions& c) {
         c.words.insert(c.words.end(), {{"light"}, {"dark"}});
       }},
      {"--load", offerEndings<Tensors, Session>},
      {"--from", offerEndings<Journal, Session, Tensors>},
      {"--resume", offerEndings<Tensors, Session>},
      {"--follow", offerEndings<Store, Tensors, Session>},
      {"window FILE", offerEndings<Toml, Session, Tensors, Journal, Store>},
      {"list ROBOT", offerEnvironments},
      {"check FILE", offerRobots},
      {"inspect FILE", offerEndings<Tensors, Session>},
      {"replay FILE", offerEndings<Journal>},
      {"difference FIRST", offerEndings<Journal, Tensors, Session, Table>},
      {"experiment PLAN", offerPlans},
      {"reproduce LIST", offerRecipes},
      {"export FILE", offerEndings<Store, Tensors>},
      {"merge PARTS", offerEndings<Store>},
      {"statistics STORE", offerEndings<Store>},
      {"lessons WORDS", offerLessonWords},
      {"query FILE", offerEndings<Tensors>},
      {"slice FILE", offerEndings<Tensors>},
      {"resample FILE", offerEndings<Tensors>},
      {"rollout FILE", offerEndings<Tensors>},
      {"robustness FILE", offerEndings<Tensors>},
  };
  return all;
}

Offer offerOf(const std::string& command, const DeclaredOption& option) {
  for (const std::string& name : {command + " " + option.name, option.name})
    if (const auto found = offers().find(name); found != offers().end()) return found->second;
  return nullptr;
}

}  // namespace

bool hasKnownValues(const std::string& command, const DeclaredOption& option) {
  return offerOf(command, option) || option.type == "FOLDER" || option.type.starts_with("FILE");
}

void offerValues(const UnfinishedLine& line, const DeclaredOption& option, Completions& into) {
  if (const Offer offer = offerOf(line.command, option)) return offer(line, into);
  if (option.type == "FOLDER") into.folders = true;
  if (!option.type.starts_with("FILE")) return;
  into.files = true;
  if (option.type.starts_with("FILE.")) into.endings = {option.type.substr(5)};
}

}  // namespace surefoot
