// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/requests/train_load.h"

#include <fmt/format.h>

#include "core/environment_library.h"
#include "core/saved/q_file.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

Status checkSame(const TensorFile& file, const char* option, const std::optional<std::string>& given,
                 const std::string& theirs) {
  if (!given || *given == theirs) return Done{};
  return fileError(file.name, fmt::format("it was learned with {0} {1}, and {0} {2} is given; leave {0} away.", option,
                                          theirs, shortened(*given)));
}

/// Sets the values of a preset or scenario.
Status bring(const Result<const AssignmentEntry*>& entry, bool chosen, Parameters& parameters) {
  if (!chosen) return Done{};
  if (!entry) return entry.error();
  for (const auto& [key, value] : (*entry)->values)
    if (parameters.find(key))
      if (const Status s = parameters.set(key, value); !s) return s;
  return Done{};
}

}  // namespace

Result<Configuration> configurationUpon(const Registry& registry, const TensorFile& file, const ChosenNames& chosen,
                                        const std::vector<Assignment>& assignments, bool fromOther) {
  const auto theirs = configurationOf(registry, file);
  if (!theirs) return theirs.error();
  const Names& names = theirs->names;
  std::optional<std::string> environment = chosen.environment;
  if (environment) {
    auto named = environmentNamed(registry, *environment);
    if (!named) return named.error();
    environment = std::move(*named);
  }
  // Another version of the same robot is another model of it, which may go on with what was learned if it has the same
  // state and actions (checkTask); any other robot must be asked for.
  const bool version = environment && plainName(*environment) == plainName(names.environment);
  if (!version && !fromOther)
    if (const Status s = checkSame(file, "--environment", environment, names.environment); !s) return s.error();
  if (const Status s = checkSame(file, "--features", chosen.features, names.features); !s) return s.error();
  Names wanted = namesOr(chosen, names);
  if (environment && *environment != names.environment) {  // its own presets and scenarios
    wanted.preset = chosen.preset.value_or("");
    wanted.scenario = chosen.scenario.value_or("");
  }
  auto ours = configure(registry, wanted, {});
  if (!ours) return ours.error();
  for (const auto& [parameter, value, usual] : theirs->parameters.all())
    if (value != usual && ours->parameters.find(parameter.key))
      if (const Status s = ours->parameters.set(parameter.key, value); !s) return s.error();
  const auto preset = findPreset(registry, ours->names.environment, chosen.preset.value_or(""));
  if (const Status s = bring(preset, chosen.preset.has_value(), ours->parameters); !s) return s.error();
  const auto scenario = findScenario(registry, ours->names.environment, chosen.scenario.value_or(""));
  if (const Status s = bring(scenario, chosen.scenario.has_value(), ours->parameters); !s) return s.error();
  for (const Assignment& a : assignments)
    if (const Status s = ours->parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return ours;
}

}  // namespace surefoot
