// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library/description.h"
#include "app/library/life_handle.h"
#include "app/library/ours.h"
#include "core/saved/checkpoint.h"
#include "core/text/number_text.h"

using namespace surefoot;

namespace {

using Json = nlohmann::json;

/// The options of `surefoot train` that say the same.
Result<TrainOptions> optionsOf(const Json& json, const surefoot_world* world, const surefoot_policy* policy) {
  TrainOptions options;
  options.openEnded = true;
  auto names = namesIn(json);
  if (!names) return names.error();
  options.names = std::move(*names);
  auto assignments = assignmentsIn(json.value("parameters", Json()));
  if (!assignments) return assignments.error();
  options.assignments = std::move(*assignments);
  for (const auto& [key, place] : {std::pair{"load", &options.load}, std::pair{"resume", &options.resume}}) {
    auto text = textOf(json, key);
    if (!text) return text.error();
    *place = std::move(*text);
  }
  if (world && !options.resume) options.names.environment = "own";  // a life that goes on knows its names
  if (policy && !options.resume) options.names.policy = "own";
  auto seed = numberOf(json, "seed");
  if (!seed) return seed.error();
  options.seed = std::move(*seed);
  return options;
}

Status makeIt(surefoot_life& made, const Json& json, const surefoot_world* world, const surefoot_policy* policy) {
  if (const Status s = addOwnParts(made.registry, world, policy, made.mishap); !s) return s;
  made.hasOwnPolicy = policy != nullptr;
  const auto options = optionsOf(json, world, policy);
  if (!options) return options.error();
  const auto index = numberOf(json, "life");
  if (!index) return index.error();
  if (*index) {
    const auto life = parseWhole("life", **index, 0, 1'000'000'000);
    if (!life) return life.error();
    made.index = static_cast<int>(*life);
  }
  const auto programs = flagOf(json, "programs");
  if (!programs) return programs.error();
  auto request = makeTrainRequest(made.registry, *options, false);
  if (!request) return request.error();
  made.configuration = std::move(request->configuration);
  if (*programs) allowProgram(made.registry, made.configuration);
  if (!request->resumed) {
    auto life = makeLife(made.registry, made.configuration, made.index, true);
    if (!life) return life.error();
    made.life = std::move(*life);
    made.life->keepInputs();
    return Done{};
  }
  auto resumed = resume(made.registry, request->resumed, request->limits);
  if (!resumed) return resumed.error();
  made.life = std::move(resumed->life);
  return Done{};
}

}  // namespace

surefoot_status surefoot_life_make(const char* configuration, const surefoot_world* world,
                                   const surefoot_policy* policy, surefoot_life** life) {
  return makeHandle(life, [&]() -> Result<std::unique_ptr<surefoot_life>> {
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    const auto json = parseDescription(configuration, "configuration",
                                       {"environment", "preset", "scenario", "agent", "features", "policy",
                                        "parameters", "seed", "life", "load", "resume", "programs"});
    if (!json) return json.error();
    auto made = std::make_unique<surefoot_life>();
    made->registry = **registry;
    if (const Status s = makeIt(*made, *json, world, policy); !s) return s.error();
    return made;
  });
}

surefoot_status surefoot_life_close(surefoot_life* life) {
  return closeHandle(life);
}
