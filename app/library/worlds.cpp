// SPDX-License-Identifier: GPL-3.0-or-later
// Many worlds of one kind, which take a step in one call.
#include <algorithm>

#include "app/library/description.h"
#include "app/library/handle.h"
#include "app/library/ours.h"
#include "app/library/outcomes.h"
#include "core/basics/typed_json.h"

namespace surefoot {

/// One of many.
struct OneWorld {
  std::unique_ptr<Environment> environment{};
  Random random{1};
  Ending ending = Ending::None;  ///< of its last step
  bool begun = false;

  bool over() const { return ending != Ending::None; }
  Status reset() {
    environment->reset(random);
    begun = environment->unanswered().empty();
    ending = Ending::None;
    return begun ? Status(Done{}) : Status(Error{environment->unanswered(), ErrorKind::Unanswered});
  }
};

}  // namespace surefoot

using namespace surefoot;

struct surefoot_worlds : Handle {
  Configuration configuration{};
  std::vector<OneWorld> worlds{};
  std::int32_t again = SUREFOOT_AGAIN_NEXT_STEP;  ///< surefoot_again
  std::size_t variables = 0, terms = 0;           ///< of the state; of the reward

  const Task& task() const { return worlds[0].environment->task(); }
  void tellState(std::size_t world, double* states) const {
    const auto now = worlds[world].environment->state();
    if (states) std::copy(now.begin(), now.end(), states + world * variables);
  }
  void tell(std::size_t world, const Outcome& outcome, const surefoot_batch& batch) const;
  Status step(std::size_t world, Action action, const surefoot_batch& batch);
};

void surefoot_worlds::tell(std::size_t i, const Outcome& o, const surefoot_batch& batch) const {
  if (batch.rewards) batch.rewards[i] = o.reward;
  if (batch.terminated) batch.terminated[i] = o.ending == Ending::Terminal;
  if (batch.truncated) batch.truncated[i] = o.ending == Ending::Truncated;
  if (batch.falls) batch.falls[i] = o.event == Event::Fall;
  if (batch.successes) batch.successes[i] = o.event == Event::Success;
  if (batch.reward_terms) std::copy_n(o.terms.begin(), terms, batch.reward_terms + i * terms);
}

Status surefoot_worlds::step(std::size_t i, Action action, const surefoot_batch& batch) {
  OneWorld& world = worlds[i];
  Outcome outcome{};
  if (!world.over()) {
    outcome = world.environment->step(action);
    if (outcome.ending == Ending::Unanswered) return Error{world.environment->unanswered(), ErrorKind::Unanswered};
    world.ending = outcome.ending;
    tellState(i, batch.last_states);
    if (world.over() && again == SUREFOOT_AGAIN_AT_ONCE)
      if (const Status s = world.reset(); !s) return s;
  } else {
    if (again == SUREFOOT_AGAIN_WHEN_ASKED) outcome.ending = world.ending;
    if (again == SUREFOOT_AGAIN_NEXT_STEP)
      if (const Status s = world.reset(); !s) return s;
    tellState(i, batch.last_states);
  }
  tellState(i, batch.states);
  tell(i, outcome, batch);
  return Done{};
}

constexpr std::size_t kMostWorlds = 100'000;

surefoot_status surefoot_worlds_make(const char* description, size_t count, int32_t again, surefoot_worlds** worlds) {
  return makeHandle(worlds, [&]() -> Result<std::unique_ptr<surefoot_worlds>> {
    if (count < 1 || count > kMostWorlds)
      return Error{fmt::format("count: {} is not allowed; it goes from 1 to {}.", count, kMostWorlds)};
    if (again < SUREFOOT_AGAIN_WHEN_ASKED || again > SUREFOOT_AGAIN_AT_ONCE)
      return Error{fmt::format("again: {} is not allowed; it goes from 0 to 2.", again)};
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    auto configuration = worldIn(**registry, description);
    if (!configuration) return configuration.error();
    auto made = std::make_unique<surefoot_worlds>();
    made->again = again;
    made->worlds.resize(count);
    std::uint64_t seed = 0;
    for (OneWorld& world : made->worlds) {
      auto environment = makeEnvironment(**registry, *configuration);
      if (!environment) return environment.error();
      world.environment = std::move(*environment);
      world.random = Random(++seed);
    }
    made->configuration = std::move(*configuration);
    made->variables = made->task().state.size(), made->terms = made->task().rewardTerms.size();
    return made;
  });
}

surefoot_status surefoot_worlds_close(surefoot_worlds* worlds) {
  return closeHandle(worlds);
}

surefoot_status surefoot_worlds_about(surefoot_worlds* worlds, const char** json) {
  return call(worlds, "worlds", [&](surefoot_worlds& w) {
    return handOut(w, jsonText(aboutWorld(*w.worlds[0].environment, w.configuration)), json);
  });
}

surefoot_status surefoot_worlds_reset(surefoot_worlds* worlds, const uint64_t* seeds, const uint8_t* which,
                                      double* states) {
  return call(worlds, "worlds", [&](surefoot_worlds& w) -> Status {
    for (std::size_t i = 0; i < w.worlds.size(); ++i) {
      if (which && !which[i]) {
        w.tellState(i, states);
        continue;
      }
      if (seeds) w.worlds[i].random = Random(seeds[i]);
      if (const Status s = w.worlds[i].reset(); !s) return s;
      w.tellState(i, states);
    }
    return Done{};
  });
}

surefoot_status surefoot_worlds_step(surefoot_worlds* worlds, const int64_t* actions, const surefoot_batch* batch) {
  return call(worlds, "worlds", [&](surefoot_worlds& w) -> Status {
    if (!actions || !batch || !batch->states) return Error{"actions, batch and its states must not be NULL."};
    for (std::size_t i = 0; i < w.worlds.size(); ++i) {
      if (!w.worlds[i].begun) return Error{fmt::format("world {}: no episode has begun; reset it first.", i)};
      if (const Status s = checkAction(w.task(), actions[i]); !s)
        return Error{fmt::format("world {}: {}", i, s.error().message)};
    }
    for (std::size_t i = 0; i < w.worlds.size(); ++i)
      if (const Status s = w.step(i, static_cast<Action>(actions[i]), *batch); !s) return s;
    return Done{};
  });
}
