// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook's pages of parameters.
#include <algorithm>

#include "core/handbook/declared_pages.h"
#include "core/handbook/page_writer.h"
#include "core/life/rewinding.h"

namespace surefoot {

namespace {

/// A group of parameters, by what their keys begin with.
struct ParameterGroup {
  std::string_view key;
  const char *title, *about;
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

/// All parameters, each key once: the first that declares it, and of the worlds the usual one first, whose defaults are
/// told.
Parameters allParameters(const Registry& registry) {
  Parameters all;
  for (const PolicyEntry& entry : registry.policies) all.add(*entry.make(), "policy.");
  Rewinding rewinding;
  all.add(rewinding, "life.");
  std::vector<const EnvironmentEntry*> worlds = {&usualWorld(registry)};
  for (const EnvironmentEntry& world : registry.environments) worlds.push_back(&world);
  for (const EnvironmentEntry* world : worlds) {
    const auto environment = world->make();
    for (const AgentEntry& agent : registry.agents)
      for (const FeatureEntry& features : registry.features)  // a misfit adds nothing
        static_cast<void>(static_cast<bool>(agent.declare(environment->task(), features.name, all)));
  }
  return all;
}

}  // namespace

std::string groupTitle(std::string_view key) {
  for (const ParameterGroup& group : kGroups)
    if (group.key == key) return group.title;
  return std::string(key);
}

const EnvironmentEntry& usualWorld(const Registry& registry) {
  const auto usual = std::find_if(registry.environments.begin(), registry.environments.end(),
                                  [](const EnvironmentEntry& entry) { return entry.name == "pendulum"; });
  return usual == registry.environments.end() ? registry.environments.front() : *usual;
}

Handbook parameterPages(const Registry& registry, const HandbookSpeech& speech) {
  const PageWriter writer(speech);
  const Parameters all = allParameters(registry);
  Handbook pages;
  for (const ParameterGroup& group : kGroups) {
    std::string text;
    for (const auto& entry : all.all())
      if (entry.parameter.key.starts_with(fmt::format("{}.", group.key))) text += writer.paragraph(entry);
    if (text.empty()) continue;
    const std::string how = speech.say(
        "Set one with {0}, in the form, or in a plan. A default can be another one in a world that says so; {1} and "
        "the form tell.",
        "`--set KEY=VALUE`", "`surefoot list`");
    pages.push_back({fmt::format("parameters-{}", group.key), kParameters, speech.say(group.title),
                     fmt::format("{} {}\n\n{}", writer.said(group.about), how, text)});
  }
  return pages;
}

}  // namespace surefoot
