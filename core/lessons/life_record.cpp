// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lessons/life_record.h"

#include <fmt/format.h>

#include <charconv>

#include "core/saved/q_file.h"
#include "core/text/printable.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

constexpr int kMostAncestors = 4;  ///< lives that a life has learned from, one from the other
constexpr std::int64_t kMostRecorded = 20'000'000;

std::string hexOf(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

std::optional<std::int64_t> wholeIn(const Json& json, const char* key, std::int64_t most) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_number_integer()) return std::nullopt;
  if (json[key].is_number_unsigned() && json[key].get<std::uint64_t>() > static_cast<std::uint64_t>(most))
    return std::nullopt;
  const auto value = json[key].get<std::int64_t>();
  return value >= 0 && value <= most ? std::optional(value) : std::nullopt;
}

/// Done when the life had taken all its steps, and none after it.
Status doNow(const Registry& registry, Life& life, const CommandText& change) {
  if (change.key == "policy") {
    auto policy = makePolicy(registry, change.value, life.parameters());
    if (!policy) return policy.error();
    life.setPolicy(change.value, std::move(*policy));
    return Done{};
  }
  if (change.key == "push" || change.key == "place" || change.key == "go_on")
    return Done{};  // what is judged was before it
  Parameters changed = life.parameters();
  if (const Status s = changed.set(change.key, std::string_view(change.value)); !s) return s;
  return life.set(change.key, changed.get(change.key));
}

Result<LifeRecord> parse(const Json& json, int ancestors) {
  LifeRecord record{
      .agent = textIn(json, "agent"), .scenario = textIn(json, "scenario"), .policy = textIn(json, "policy")};
  const auto seed = wholeIn(json, "seed", std::numeric_limits<std::int64_t>::max());
  const auto steps = wholeIn(json, "steps", kMostRecorded);
  const std::string hash = textIn(json, "hash");
  const auto [end, code] = std::from_chars(hash.data(), hash.data() + hash.size(), record.hash, 16);
  if (!seed || !steps || code != std::errc{} || end != hash.data() + hash.size() || hash.empty())
    return Error{"a life lacks its seed, its steps or its hash."};
  record.seed = static_cast<std::uint64_t>(*seed);
  record.steps = *steps;
  for (const auto& [key, value] : partOf(json, "set").items())
    if (value.is_string()) record.set.push_back({key, value.get<std::string>()});
  for (const Json& change : partOf(json, "changes")) {
    const auto at = wholeIn(change, "step", *steps);
    if (!at) return Error{"something is done to a life at a step that it never took."};
    record.changes.push_back({*at, textIn(change, "key"), textIn(change, "value")});
  }
  if (!json.contains("learned_from")) return record;
  if (ancestors == 0) return Error{fmt::format("more than {} lives learned one from the other.", kMostAncestors)};
  auto before = parse(json["learned_from"], ancestors - 1);
  if (!before) return before;
  record.learnedFrom = std::make_shared<const LifeRecord>(std::move(*before));
  return record;
}

}  // namespace

LifeRecord recordOf(const Lesson& lesson, const Configuration& began, const Life& life,
                    std::shared_ptr<const LifeRecord> learnedFrom) {
  LifeRecord record{.learnedFrom = std::move(learnedFrom),
                    .agent = began.names.agent,
                    .scenario = began.names.scenario,
                    .policy = began.names.policy,
                    .seed = began.seed,
                    .steps = life.steps(),
                    .hash = life.hash()};
  for (const auto& entry : began.parameters.all()) {
    const Parameters::Entry* start = lesson.start.parameters.find(entry.parameter.key);
    if (start && start->value == entry.value) continue;
    record.set.push_back({entry.parameter.key, formatValue(entry.parameter, entry.value)});
  }
  for (const Change& change : life.changes()) record.changes.push_back({change.step, change.key, change.after});
  return record;
}

Result<Configuration> startOf(const Registry& registry, const Lesson& lesson, const LifeRecord& record) {
  Names names = lesson.start.names;
  names.agent = record.agent, names.scenario = record.scenario, names.policy = record.policy;
  auto began = configurationUnder(registry, lesson.start, names);
  if (!began) return began;
  began->seed = record.seed;
  for (const Assignment& a : record.set)
    if (const Status s = began->parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return began;
}

Result<LifeInHand> relive(const Registry& registry, const Lesson& lesson, const LifeRecord& record,
                          const std::atomic<bool>* interrupted) {
  auto began = startOf(registry, lesson, record);
  if (!began) return began.error();
  if (record.learnedFrom) {
    auto before = relive(registry, lesson, *record.learnedFrom, interrupted);
    if (!before) return before;
    *began = transferred(*before->life, std::move(*began));
  }
  Configuration lived = *began;
  for (const CommandText& change : record.changes)
    if (change.step < record.steps) lived.commands.push_back(change);
  auto life = makeLife(registry, lived, 0, true);
  if (!life) return life.error();
  (*life)->keepInputs();
  while ((*life)->steps() < record.steps && !(*life)->finished()) {
    if (interrupted && *interrupted) return Error{"It was stopped."};
    (*life)->step();
  }
  for (const CommandText& change : record.changes)
    if (change.step >= record.steps)
      if (const Status s = doNow(registry, **life, change); !s) return s.error();
  if ((*life)->steps() != record.steps || (*life)->hash() != record.hash)
    return Error{"lived again, this life comes out otherwise than its record says."};
  return LifeInHand{std::move(*began), std::move(*life), record.learnedFrom};
}

Configuration LifeInHand::now() const {
  Configuration now = began;
  now.parameters = life->parameters();
  now.names.policy = life->policyName();
  return now;
}

Configuration transferred(const Life& from, Configuration to) {
  Configuration learned = to;
  learned.parameters = from.parameters();
  to.start = std::make_shared<const TensorFile>(qFileOf(from, learned));
  to.beganWith = {};
  return to;
}

Json asJson(const LifeRecord& record) {
  Json json = {{"agent", record.agent},
               {"policy", record.policy},
               {"seed", record.seed},
               {"steps", record.steps},
               {"hash", hexOf(record.hash)}};
  if (!record.scenario.empty()) json["scenario"] = record.scenario;
  for (const Assignment& a : record.set) json["set"][a.key] = a.value;
  for (const CommandText& c : record.changes)
    json["changes"].push_back({{"step", c.step}, {"key", c.key}, {"value", c.value}});
  if (record.learnedFrom) json["learned_from"] = asJson(*record.learnedFrom);
  return json;
}

Result<LifeRecord> lifeRecordOf(const Json& json) {
  return parse(json, kMostAncestors);
}

}  // namespace surefoot
