// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/declared_pages.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/environment_library.h"
#include "core/formulas.h"
#include "core/glossary.h"
#include "core/life/rewinding.h"
#include "core/text/number_text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

/// Text in which no letter means anything to Markdown.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_{}[]<>#|&").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

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

std::string paragraphOf(const Parameters::Entry& entry) {
  const Parameter& p = entry.parameter;
  const std::string unit = p.unit.empty() ? "" : " " + p.unit;
  std::string text = fmt::format("### <a name=\"{}\"></a>{}{}\n\n`{}`", p.key, plain(p.title),
                                 p.symbol.empty() ? "" : ", " + plain(p.symbol), p.key);
  if (p.kind == Kind::Choice)
    text +=
        fmt::format(", one of {}; default {}.", plain(joinWords(p.choices, "or")), plain(formatValue(p, p.fallback)));
  else
    text += fmt::format(", {} … {}{}; default {}{}.", boundText(p.low), boundText(p.high), plain(unit),
                        plain(formatValue(p, p.fallback)), plain(unit));
  text += fmt::format(" {}\n\n{}", whenText(p.when), plain(p.help));
  if (!p.origin.empty()) text += fmt::format(" The default is from: {}.", plain(p.origin));
  if (!p.needs.empty()) text += fmt::format(" Has an effect only with `{}`.", p.needs);
  if (const std::string formula = formulaOf(p); !formula.empty()) text += fmt::format("\n\n> {}", plain(formula));
  return text + "\n\n";
}

std::string paragraphsOf(const Parameters& parameters) {
  std::string text;
  for (const auto& entry : parameters.all()) text += paragraphOf(entry);
  return text;
}

/// A group of parameters, by what their keys begin with.
struct ParameterGroup {
  std::string_view key, title, about;
};
constexpr ParameterGroup kGroups[] = {
    {"policy", "Policies", "What the policies have, with their schedules and what they do with the risk of a fall."},
    {"agent", "Learning", "What the learning rules have in common."},
    {"features", "Representation",
     "How values are kept: tiles, radial basis functions, tables. Every state variable has a resolution of its own."},
    {"positive", "Q⁺ of Sarsa_2Q", "The learning and the representation of the expected gains."},
    {"negative", "Q⁻ of Sarsa_2Q", "The learning and the representation of the expected losses."},
    {"split", "How rewards are split for Sarsa_2Q", "Which part of a reward is a gain and which a loss."},
    {"shaping", "Shaping of rewards", "A coarse value function that is learned first and shapes the rewards."},
    {"risk", "The risk of a fall", "The probability that an action ends in a fall, learned beside the values."},
    {"life", "A life", "Falls that are taken back."}};

std::string titleOf(std::string_view key) {
  for (const ParameterGroup& group : kGroups)
    if (group.key == key) return std::string(group.title);
  return std::string(key);
}

/// What the glossary says, with the equation set apart.
std::string meaning(std::string_view name) {
  const Word* word = wordOf(name);
  if (!word) return "";
  std::string text = plain(word->text) + "\n\n";
  if (!word->formula.empty()) text += fmt::format("> {}\n\n", plain(word->formula));
  if (!word->source.empty()) text += fmt::format("Source: {}.\n\n", plain(word->source));
  return text;
}

/// "policy.epsilon_end" and its neighbours.
bool isOfSchedule(const std::string& key) {
  for (const char* part : {"_schedule", "_end", "_over", "_per"})
    if (key.ends_with(part)) return true;
  return false;
}

/// "Parameters: [ε](…), …": those of a policy or a rule singly, of representations the pages.
std::string parameterLinks(const Parameters& parameters) {
  std::vector<std::string> links;
  for (const auto& entry : parameters.all()) {
    const std::string& key = entry.parameter.key;
    if (isOfSchedule(key)) continue;  // its page tells of it beside what it changes
    const std::string page = parameterPage(key), group = key.substr(0, key.find('.'));
    const bool single = group == "policy" || group == "agent";
    const std::string link = single ? fmt::format("[{}]({})", plain(entry.parameter.title), page)
                                    : fmt::format("[{}]({})", titleOf(group), page.substr(0, page.find('#')));
    if (std::find(links.begin(), links.end(), link) == links.end()) links.push_back(link);
  }
  return links.empty() ? "" : fmt::format("**Parameters**: {}.\n\n", fmt::join(links, ", "));
}

/// The pendulum's, which is the usual one.
const EnvironmentEntry& usualWorld(const Registry& registry) {
  const auto usual = std::find_if(registry.environments.begin(), registry.environments.end(),
                                  [](const EnvironmentEntry& entry) { return entry.name == "pendulum"; });
  return usual == registry.environments.end() ? registry.environments.front() : *usual;
}

/// The parameters of an agent on the representation with which it is usual.
Parameters parametersOf(const Registry& registry, const AgentEntry& agent) {
  Parameters parameters;
  const auto environment = usualWorld(registry).make();
  static_cast<void>(static_cast<bool>(agent.declare(environment->task(), registry.features.front().name, parameters)));
  return parameters;
}

std::string presetsText(const Registry& registry, const std::string& environment) {
  std::string text;
  const auto tell = [&](const char* heading, const std::vector<const AssignmentEntry*>& entries) {
    if (entries.empty()) return;
    text += fmt::format("## {}\n\n", heading);
    for (const AssignmentEntry* entry : entries)
      text +=
          fmt::format("- **{}**: {}\n", plain(entry->name), plain(entry->help.empty() ? entry->title : entry->help));
    text += "\n";
  };
  tell("Presets", presetsOf(registry, environment));
  tell("Scenarios", scenariosOf(registry, environment));
  return text;
}

std::string taskText(const Task& task) {
  std::string text = "## State\n\n";
  for (const StateVariable& v : task.state)
    text += fmt::format("- {} ({}): {} … {}{}\n", plain(v.title), plain(v.symbol), boundText(v.low), boundText(v.high),
                        v.unit.empty() ? "" : " " + plain(v.unit));
  text += fmt::format("\n## Actions\n\n{} actions", task.actions.size());
  if (!task.actionTitle.empty()) text += ": " + plain(task.actionTitle);
  text += ".\n\n";
  if (!task.rewardTerms.empty()) text += fmt::format("Rewards: {}.\n\n", plain(joinWords(task.rewardTerms, "and")));
  return text;
}

}  // namespace

Handbook methodPages(const Registry& registry) {
  Handbook pages;
  const auto add = [&](const Named& entry, const std::string& rest) {
    pages.push_back({methodPage(entry.name), kMethods, entry.title,
                     fmt::format("`{}`. {}\n\n{}{}", entry.name, plain(entry.help), meaning(entry.name), rest)});
  };
  for (const PolicyEntry& entry : registry.policies) {
    Parameters parameters;
    parameters.add(*entry.make(), "policy.");
    add(entry, parameterLinks(parameters));
  }
  for (const AgentEntry& entry : registry.agents) add(entry, parameterLinks(parametersOf(registry, entry)));
  for (const FeatureEntry& entry : registry.features) add(entry, "");
  std::string words;
  for (const Word& word : glossary())
    if (word.name.empty())
      words += fmt::format("**{}**. {}{}{}\n\n", plain(word.title), plain(word.text),
                           word.formula.empty() ? "" : fmt::format(" `{}`", word.formula),
                           word.source.empty() ? "" : fmt::format(" ({})", plain(word.source)));
  pages.push_back({"words", kMethods, "Words", std::move(words)});
  return pages;
}

Handbook worldPages(const Registry& registry) {
  Handbook pages;
  for (const EnvironmentEntry& entry : registry.environments) {
    const auto environment = entry.make();
    Parameters parameters;
    parameters.add(*environment, "environment.");
    pages.push_back({worldPage(entry.name), kWorlds, entry.title,
                     fmt::format("`{}`. {}\n\n{}{}{}{}", entry.name, plain(entry.help), meaning(entry.name),
                                 taskText(environment->task()), presetsText(registry, entry.name),
                                 parameters.all().empty() ? "" : "## Parameters\n\n" + paragraphsOf(parameters))});
  }
  return pages;
}

Handbook parameterPages(const Registry& registry) {
  Parameters all;  // each key once: the first that declares it
  for (const PolicyEntry& entry : registry.policies) all.add(*entry.make(), "policy.");
  Rewinding rewinding;
  all.add(rewinding, "life.");
  std::vector<const EnvironmentEntry*> worlds = {&usualWorld(registry)};  // whose defaults are told
  for (const EnvironmentEntry& world : registry.environments) worlds.push_back(&world);
  for (const EnvironmentEntry* world : worlds) {
    const auto environment = world->make();
    for (const AgentEntry& agent : registry.agents)
      for (const FeatureEntry& features : registry.features)  // a misfit adds nothing
        static_cast<void>(static_cast<bool>(agent.declare(environment->task(), features.name, all)));
  }
  Handbook pages;
  for (const ParameterGroup& group : kGroups) {
    std::string text;
    for (const auto& entry : all.all())
      if (entry.parameter.key.starts_with(fmt::format("{}.", group.key))) text += paragraphOf(entry);
    if (text.empty()) continue;
    pages.push_back(
        {fmt::format("parameters-{}", group.key), kParameters, std::string(group.title),
         fmt::format("{} Set one with `--set KEY=VALUE`, in the form, or in a plan. A default can be another "
                     "one in a world that says so; `surefoot list` and the form tell.\n\n{}",
                     group.about, text)});
  }
  return pages;
}

Handbook commandPages(const std::vector<CommandHelp>& commands) {
  Handbook pages;
  for (const CommandHelp& command : commands) {
    std::string text = fmt::format("{}.\n\n```sh\n{}\n```\n\n", plain(command.summary), command.line);
    if (!command.remark.empty()) text += plain(command.remark) + "\n\n";
    if (!command.examples.empty()) text += "## Examples\n\n```sh\n";
    for (const auto& [words, does] : command.examples) text += fmt::format("# {}\n{}\n", does, words);
    if (!command.examples.empty()) text += "```\n\n";
    if (!command.options.empty()) text += "## Options\n\n";
    for (const auto& [words, help] : command.options) text += fmt::format("- `{}`: {}\n", words, plain(help));
    pages.push_back({commandPage(command.name), kCommands, "surefoot " + command.name, std::move(text)});
  }
  return pages;
}

}  // namespace surefoot
