// SPDX-License-Identifier: GPL-3.0-or-later
// What a life has learned and lived, what is done to it, and its files.
#include <fmt/format.h>

#include <algorithm>

#include "app/library/episodes.h"
#include "app/library/learned.h"
#include "app/library/life_handle.h"
#include "app/library/outcomes.h"
#include "core/files/whole_file.h"
#include "core/saved/checkpoint.h"
#include "core/saved/q_file.h"
#include "core/store/store.h"

using namespace surefoot;

surefoot_status surefoot_life_episodes(surefoot_life* life, size_t first, surefoot_episode* rows, size_t count,
                                       size_t* there) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    const auto& log = l.life->log().rows();
    if (!there) return Error{"there: it is NULL."};
    *there = log.size();
    return tellEpisodes(log.size(), first, rows, count, [&](std::size_t i) {
      const EpisodeRow& row = log[i];
      surefoot_episode e{.episode = row.episode,
                         .transitions = row.steps,
                         .steps = row.lifeSteps,
                         .reward = row.reward,
                         .average_reward = row.averageReward,
                         .measures = {},
                         .falls = row.falls,
                         .ending = static_cast<std::int32_t>(endingCode(row))};
      std::copy(row.measures.begin(), row.measures.end(), e.measures);
      return e;
    });
  });
}

surefoot_status surefoot_life_values(surefoot_life* life, int32_t layer, const double* states, size_t n, double* values,
                                     size_t count) {
  return withLife(life, [&](surefoot_life& l) {
    return valuesOf(l.life->agent().values(), l.task(), layer, {states, n}, values, count);
  });
}

surefoot_status surefoot_life_probabilities(surefoot_life* life, const double* states, size_t n, double* pi,
                                            size_t count) {
  return withLife(life, [&](surefoot_life& l) {
    return probabilitiesOf(l.life->agent().values(), l.task(), l.life->policy(), {states, n}, pi, count);
  });
}

surefoot_status surefoot_life_visits(surefoot_life* life, const double* states, size_t n, double* visits,
                                     size_t count) {
  return withLife(life, [&](surefoot_life& l) {
    return visitsOf(l.life->agent().values(), l.task(), {states, n}, visits, count);
  });
}

surefoot_status surefoot_life_set(surefoot_life* life, const char* key, const char* value) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    const auto name = given(key, "key"), text = given(value, "value");
    if (!name) return name.error();
    if (!text) return text.error();
    Parameters parameters = l.life->parameters();
    if (const Status s = parameters.set(*name, std::string_view(*text)); !s) return s;
    Configuration next = l.configuration;
    next.parameters = parameters;
    if (const auto possible = makeEnvironment(l.registry, next); !possible) return possible.error();
    return l.life->set(*name, parameters.get(*name));
  });
}

surefoot_status surefoot_life_follow(surefoot_life* life, const char* policy) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    const auto name = given(policy, "policy");
    if (!name) return name.error();
    auto made = makePolicy(l.registry, *name, l.life->parameters());
    if (!made) return made.error();
    const CautionNeeds has = usableBy(l.life->agent().values(), l.task().handMade, l.configuration.teacher != nullptr);
    if (const Status s = (*made)->caution().check(has); !s) return s;
    l.life->setPolicy(*name, std::move(*made));
    return Done{};
  });
}

surefoot_status surefoot_life_push(surefoot_life* life, double impulse) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    if (const Status s = checkPush(impulse); !s) return s;
    return l.life->push(impulse) ? Status(Done{}) : Error{"push: this environment has no body to push."};
  });
}

surefoot_status surefoot_life_place(surefoot_life* life, const double* state, size_t count) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    if (const Status s = checkArray(state, count, l.task().state.size(), "state"); !s) return s;
    return l.life->place({state, state + count});
  });
}

surefoot_status surefoot_life_save(surefoot_life* life, const char* file) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    const auto path = given(file, "file");
    if (!path) return path.error();
    if (l.life->diverged()) return Error{l.life->divergence(), ErrorKind::Diverged};
    auto place = WholeFile::createNew("file", *path);
    if (!place) return place.error();
    Configuration now = l.configuration;
    now.parameters = l.life->parameters(), now.names.policy = l.life->policyName();
    return place->commit(qFileOf(*l.life, now).write());
  });
}

surefoot_status surefoot_life_checkpoint(surefoot_life* life, const char* file) {
  return withLife(life, [&](surefoot_life& l) -> Status {
    const auto path = given(file, "file");
    if (!path) return path.error();
    if (l.life->diverged()) return Error{l.life->divergence(), ErrorKind::Diverged};
    return writeWhole("file", *path, checkpointOf(*l.life, l.configuration, true).write());
  });
}
