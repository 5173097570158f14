// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/declared_pages.h"

#include <algorithm>

#include "core/environment_library.h"
#include "core/glossary.h"
#include "core/handbook/page_writer.h"

namespace surefoot {

namespace {

/// "policy.epsilon_end" and its neighbours.
bool isOfSchedule(const std::string& key) {
  for (const char* part : {"_schedule", "_end", "_over", "_per"})
    if (key.ends_with(part)) return true;
  return false;
}

/// "Parameters: [ε](…), …": those of a policy or a rule singly, of representations the pages.
std::string parameterLinks(const PageWriter& writer, const Parameters& parameters) {
  std::vector<std::string> links;
  for (const auto& entry : parameters.all()) {
    const std::string& key = entry.parameter.key;
    if (isOfSchedule(key)) continue;  // its page tells of it beside what it changes
    const std::string page = parameterPage(key), group = key.substr(0, key.find('.'));
    const bool single = group == "policy" || group == "agent";
    const std::string link =
        single ? fmt::format("[{}]({})", writer.said(entry.parameter.title), page)
               : fmt::format("[{}]({})", writer.said(groupTitle(group)), page.substr(0, page.find('#')));
    if (std::find(links.begin(), links.end(), link) == links.end()) links.push_back(link);
  }
  return links.empty() ? "" : fmt::format("**{}**: {}.\n\n", writer.said("Parameters"), fmt::join(links, ", "));
}

/// The parameters of an agent on the representation with which it is usual.
Parameters parametersOf(const Registry& registry, const AgentEntry& agent) {
  Parameters parameters;
  const auto environment = usualWorld(registry).make();
  static_cast<void>(static_cast<bool>(agent.declare(environment->task(), registry.features.front().name, parameters)));
  return parameters;
}

std::string presetsText(const PageWriter& writer, const Registry& registry, const std::string& environment) {
  std::string text;
  const auto tell = [&](const char* heading, const std::vector<const AssignmentEntry*>& entries) {
    if (entries.empty()) return;
    text += writer.heading(heading);
    for (const AssignmentEntry* entry : entries)
      text += fmt::format("- **{}**: {}\n", plain(entry->name),
                          writer.said(entry->help.empty() ? entry->title : entry->help));
    text += "\n";
  };
  tell("Presets", presetsOf(registry, environment));
  tell("Scenarios", scenariosOf(registry, environment));
  return text;
}

std::string taskText(const PageWriter& writer, const Task& task) {
  std::string text = writer.heading("State");
  for (const StateVariable& v : task.state)
    text += fmt::format("- {} ({}): {} … {}{}\n", writer.said(v.title), plain(v.symbol), writer.bound(v.low),
                        writer.bound(v.high), v.unit.empty() ? "" : " " + plain(v.unit));
  text += "\n" + writer.heading("Actions") + writer.speech().say("{0} actions", task.actions.size());
  if (!task.actionTitle.empty()) text += ": " + writer.said(task.actionTitle);
  text += ".\n\n";
  if (!task.rewardTerms.empty())
    text += writer.speech().say("Rewards: {0}.", writer.list(task.rewardTerms, "and")) + "\n\n";
  return text;
}

}  // namespace

Handbook methodPages(const Registry& registry, const HandbookSpeech& speech) {
  const PageWriter writer(speech);
  Handbook pages;
  const auto add = [&](const Named& entry, const std::string& rest) {
    pages.push_back(
        {methodPage(entry.name), kMethods, speech.say(entry.title),
         fmt::format("`{}`. {}\n\n{}{}", entry.name, writer.said(entry.help), writer.meaning(entry.name), rest)});
  };
  for (const PolicyEntry& entry : registry.policies) {
    Parameters parameters;
    parameters.add(*entry.make(), "policy.");
    add(entry, parameterLinks(writer, parameters));
  }
  for (const AgentEntry& entry : registry.agents) add(entry, parameterLinks(writer, parametersOf(registry, entry)));
  for (const FeatureEntry& entry : registry.features) add(entry, "");
  std::string words;
  for (const Word& word : glossary())
    if (word.name.empty())
      words +=
          fmt::format("**{}**. {}{}{}\n\n", writer.said(word.title), writer.said(word.text),
                      word.formula.empty() ? "" : fmt::format(" `{}`", translated(speech.formula, word.formula)),
                      word.source.empty() ? "" : fmt::format(" ({})", plain(translated(speech.source, word.source))));
  pages.push_back({"words", kMethods, speech.say("Words"), std::move(words)});
  return pages;
}

Handbook worldPages(const Registry& registry, const HandbookSpeech& speech) {
  const PageWriter writer(speech);
  Handbook pages;
  for (const EnvironmentEntry& entry : registry.environments) {
    const auto environment = entry.make();
    Parameters parameters;
    parameters.add(*environment, "environment.");
    std::string about;
    for (const auto& one : parameters.all()) about += writer.paragraph(one);
    pages.push_back(
        {worldPage(entry.name), kWorlds, speech.say(entry.title),
         fmt::format("`{}`. {}\n\n{}{}{}{}", entry.name, writer.said(entry.help), writer.meaning(entry.name),
                     taskText(writer, environment->task()), presetsText(writer, registry, entry.name),
                     about.empty() ? "" : writer.heading("Parameters") + about)});
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
