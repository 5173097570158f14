// SPDX-License-Identifier: GPL-3.0-or-later
// Results of experiments.
#include <fmt/format.h>

#include <limits>

#include "app/library/episodes.h"
#include "app/library/handle.h"
#include "app/library/ours.h"
#include "core/basics/typed_json.h"
#include "core/files/limited_json.h"
#include "core/findings/findings.h"
#include "core/store/store.h"

using namespace surefoot;

struct surefoot_store : Handle {
  std::unique_ptr<Store> store{};
};

namespace {

using OrderedJson = nlohmann::ordered_json;

template <class Work>
surefoot_status withStore(surefoot_store* store, const Work& work) {
  return call(store, "store", work);
}

OrderedJson about(const StoredCondition& c) {
  OrderedJson json = {{"name", c.name},   {"reference", c.reference},    {"text", c.text},
                      {"lives", c.lives}, {"goal_reward", c.goalReward}, {"step_time", nullptr}};
  if (c.stepTime > 0) json["step_time"] = c.stepTime;
  json["configuration"] = parseJson(c.configuration);
  return json;
}

Result<OrderedJson> about(const Store& store, const StoredLife& life) {
  OrderedJson json = {{"condition", life.condition},
                      {"life", life.life},
                      {"q_function", nullptr},
                      {"episodes", life.episodes},
                      {"steps", life.steps},
                      {"falls", life.falls},
                      {"states_outside", life.statesOutside},
                      {"diverged", life.diverged},
                      {"hash", fmt::format("{:016x}", life.hash)},
                      {"measures", OrderedJson::object()}};
  if (life.qFunction >= 0) json["q_function"] = life.qFunction;
  const auto measures = store.measures(life.condition, life.life);
  if (!measures) return measures.error();
  for (const StoredMeasure& m : *measures)
    if (m.episode == 0) json["measures"][m.name] = m.value;
  return json;
}

Result<OrderedJson> about(const Store& store) {
  const auto plan = store.plan();
  if (!plan) return plan.error();
  const auto lives = store.lives();
  if (!lives) return lives.error();
  const auto hash = store.contentHash();
  if (!hash) return hash.error();
  OrderedJson json = {{"title", plan->title},
                      {"seed", plan->seed},
                      {"paired", plan->paired},
                      {"version", plan->version},
                      {"note", store.note()},
                      {"content_hash", fmt::format("{:016x}", *hash)},
                      {"conditions", OrderedJson::array()},
                      {"lives", OrderedJson::array()}};
  for (const StoredCondition& c : plan->conditions) json["conditions"].push_back(about(c));
  for (const StoredLife& l : *lives) {
    auto life = about(store, l);
    if (!life) return life.error();
    json["lives"].push_back(std::move(*life));
  }
  return json;
}

}  // namespace

surefoot_status surefoot_store_open(const char* file, surefoot_store** store) {
  return makeHandle(store, [&]() -> Result<std::unique_ptr<surefoot_store>> {
    const auto path = given(file, "file");
    if (!path) return path.error();
    auto opened = Store::open(*path);
    if (!opened) return opened.error();
    auto made = std::make_unique<surefoot_store>();
    made->store = std::make_unique<Store>(std::move(*opened));
    return made;
  });
}

surefoot_status surefoot_store_close(surefoot_store* store) {
  return closeHandle(store);
}

surefoot_status surefoot_store_about(surefoot_store* store, const char** json) {
  return withStore(store, [&](surefoot_store& s) -> Status {
    const auto told = about(*s.store);
    return told ? handOut(s, jsonText(*told), json) : Status(told.error());
  });
}

surefoot_status surefoot_store_statistics(surefoot_store* store, const char** json) {
  return withStore(store, [&](surefoot_store& s) -> Status {
    const auto registry = ourRegistry();
    if (!registry) return registry.error();
    const auto findings = findingsOf(**registry, *s.store);
    return findings ? handOut(s, jsonText(findingsAsJson(*findings)), json) : Status(findings.error());
  });
}

surefoot_status surefoot_store_episodes(surefoot_store* store, int32_t condition, int32_t life, size_t first,
                                        surefoot_episode* rows, size_t count, size_t* there) {
  return withStore(store, [&](surefoot_store& s) -> Status {
    if (!there) return Error{"there: it is NULL."};
    const auto lives = s.store->lives();
    if (!lives) return lives.error();
    const auto isAsked = [&](const StoredLife& l) { return l.condition == condition && l.life == life; };
    if (std::none_of(lives->begin(), lives->end(), isAsked))
      return Error{fmt::format("condition {}, life {}: the store has no such life.", condition, life)};
    const auto episodes = s.store->episodes(condition, life);
    if (!episodes) return episodes.error();
    *there = episodes->size();
    std::int64_t steps = 0;
    for (std::size_t i = 0; i < std::min(first, episodes->size()); ++i) steps += (*episodes)[i].transitions;
    return tellEpisodes(episodes->size(), first, rows, count, [&](std::size_t i) {
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      const StoredEpisode& e = (*episodes)[i];
      steps += e.transitions;
      return surefoot_episode{.episode = static_cast<std::int64_t>(i) + 1,
                              .transitions = e.transitions,
                              .steps = steps,
                              .reward = e.reward,
                              .average_reward = kNone,
                              .measures = {kNone, kNone, kNone, kNone},
                              .falls = e.falls,
                              .ending = static_cast<std::int32_t>(e.ending)};
    });
  });
}
