// SPDX-License-Identifier: GPL-3.0-or-later
// Worlds one by one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/library/description.h"
#include "app/library/handle.h"
#include "app/library/ours.h"
#include "app/library/outcomes.h"
#include "app/library/scene_json.h"
#include "app/library/scene_raster.h"
#include "core/basics/typed_json.h"

using namespace surefoot;

struct surefoot_environment : Handle {
  Configuration configuration{};
  std::unique_ptr<Environment> world{};
  Random random{1};
  bool inEpisode = false;
  bool changed = false;  ///< parameters wait for the next episode

  const Task& task() const { return world->task(); }
  /// Parameters hold from an episode's beginning on.
  Status takeParameters() {
    if (!std::exchange(changed, false)) return Done{};
    auto made = makeEnvironment(**ourRegistry(), configuration);
    if (!made) return made.error();
    world = std::move(*made);
    return Done{};
  }
  void tellState(double* state) const {
    const auto now = world->state();
    if (state) std::copy(now.begin(), now.end(), state);
  }
};

namespace {

template <class Work>
surefoot_status inside(surefoot_environment* environment, const Work& work) {
  return call(environment, "environment", work);
}

Error noEpisode() {
  return Error{"environment: no episode has begun, or it is over; reset it first."};
}

Error unanswered(const Environment& world) {
  return {world.unanswered(), ErrorKind::Unanswered};
}

}  // namespace

surefoot_status surefoot_environment_make(const char* description, surefoot_environment** environment) {
  return makeHandle(environment, [&]() -> Result<std::unique_ptr<surefoot_environment>> {
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    auto configuration = worldIn(**registry, description);
    if (!configuration) return configuration.error();
    auto world = makeEnvironment(**registry, *configuration);
    if (!world) return world.error();
    auto made = std::make_unique<surefoot_environment>();
    made->configuration = std::move(*configuration);
    made->world = std::move(*world);
    return made;
  });
}

surefoot_status surefoot_environment_close(surefoot_environment* environment) {
  return closeHandle(environment);
}

surefoot_status surefoot_environment_about(surefoot_environment* environment, const char** json) {
  return inside(environment, [&](surefoot_environment& e) {
    OrderedJson about = aboutWorld(*e.world, e.configuration);
    return handOut(e, jsonText(about), json);
  });
}

surefoot_status surefoot_environment_set(surefoot_environment* environment, const char* key, const char* value) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    const auto name = given(key, "key"), text = given(value, "value");
    if (!name) return name.error();
    if (!text) return text.error();
    if (!name->starts_with("environment."))
      return Error{fmt::format("{}: a world has parameters that begin with \"environment.\" only.", *name)};
    Configuration next = e.configuration;
    if (const Status s = next.parameters.set(*name, std::string_view(*text)); !s) return s;
    if (const auto possible = makeEnvironment(**ourRegistry(), next); !possible) return possible.error();
    e.configuration = std::move(next);
    e.changed = true;
    return Done{};
  });
}

surefoot_status surefoot_environment_reset(surefoot_environment* environment, const uint64_t* seed, double* state) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (const Status s = e.takeParameters(); !s) return s;
    if (seed) e.random = Random(*seed);
    e.world->reset(e.random);
    e.inEpisode = e.world->unanswered().empty();
    if (!e.inEpisode) return unanswered(*e.world);
    e.tellState(state);
    return Done{};
  });
}

surefoot_status surefoot_environment_step(surefoot_environment* environment, int64_t action, surefoot_outcome* outcome,
                                          double* state, double* reward_terms) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (!e.inEpisode) return noEpisode();
    if (!outcome) return Error{"outcome: it is NULL."};
    if (const Status s = checkAction(e.task(), action); !s) return s;
    const Outcome o = e.world->step(static_cast<Action>(action));
    if (o.ending == Ending::Unanswered) return unanswered(*e.world);
    e.inEpisode = o.ending == Ending::None;
    *outcome = outcomeOf(o);
    e.tellState(state);
    if (reward_terms) std::copy_n(o.terms.begin(), e.task().rewardTerms.size(), reward_terms);
    return Done{};
  });
}

surefoot_status surefoot_environment_state(surefoot_environment* environment, double* values, size_t count) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (const Status s = checkArray(values, count, e.task().state.size(), "values"); !s) return s;
    e.tellState(values);
    return Done{};
  });
}

surefoot_status surefoot_environment_measures(surefoot_environment* environment, double* values, size_t count) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (const Status s = checkArray(values, count, e.task().measures.size(), "values"); !s) return s;
    const auto measures = e.world->measures();
    std::copy_n(measures.begin(), std::min(count, measures.size()), values);
    return Done{};
  });
}

surefoot_status surefoot_environment_signals(surefoot_environment* environment, double* values, size_t count) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (const Status s = checkArray(values, count, e.world->signals().size(), "values"); !s) return s;
    e.world->readSignals({values, count});
    return Done{};
  });
}

surefoot_status surefoot_environment_place(surefoot_environment* environment, const double* state, size_t count) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (const Status s = checkArray(state, count, e.task().state.size(), "state"); !s) return s;
    if (const Status s = e.takeParameters(); !s) return s;
    const std::span<const double> where(state, count);
    if (const Status s = checkState(e.task(), where); !s) return s;
    e.world->reset(e.random);
    if (!e.world->unanswered().empty()) return unanswered(*e.world);
    e.inEpisode = true;
    if (!e.world->place(where)) return Error{"place: this environment begins only where it always does."};
    return Done{};
  });
}

surefoot_status surefoot_environment_push(surefoot_environment* environment, double impulse) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (!e.inEpisode) return noEpisode();
    if (const Status s = checkPush(impulse); !s) return s;
    if (!e.world->push(impulse)) return Error{"push: this environment has no body to push."};
    return Done{};
  });
}

surefoot_status surefoot_environment_hand_made(surefoot_environment* environment, int64_t* action) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    if (!action) return Error{"action: it is NULL."};
    if (!e.task().handMade) return Error{"hand_made: this task has no hand-made controller."};
    if (!e.inEpisode) return noEpisode();
    *action = e.world->handMadeAction();
    return Done{};
  });
}

surefoot_status surefoot_environment_draw(surefoot_environment* environment, const char** json) {
  return inside(environment, [&](surefoot_environment& e) {
    Scene scene;
    e.world->draw(e.world->pose(), scene);
    return handOut(e, jsonText(sceneAsJson(scene)), json);
  });
}

surefoot_status surefoot_environment_render(surefoot_environment* environment, int32_t width, int32_t height,
                                            uint8_t* rgb, size_t count) {
  return inside(environment, [&](surefoot_environment& e) -> Status {
    for (const int32_t side : {width, height})
      if (side < kSmallestPicture || side > kLargestPicture)
        return Error{fmt::format("a picture of {} × {} is not allowed; each goes from {} to {} pixels.", width, height,
                                 kSmallestPicture, kLargestPicture)};
    const auto needed = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
    if (const Status s = checkArray(rgb, count, needed, "rgb"); !s) return s;
    Scene scene;
    e.world->draw(e.world->pose(), scene);
    return paintInto(scene, width, height, rgb);
  });
}
