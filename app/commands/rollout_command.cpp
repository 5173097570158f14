// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot rollout`: lives what a Q-function has learned, learns nothing, and writes every signal at every step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/action_text.h"
#include "app/commands/commands.h"
#include "app/commands/rollout_film.h"
#include "app/process/exit_code.h"
#include "app/process/interrupt.h"
#include "app/reports/strides_report.h"
#include "app/requests/requests.h"
#include "core/basics/hash64.h"
#include "core/basics/typed_json.h"
#include "core/environment_library.h"
#include "core/files/whole_file.h"
#include "core/saved/stored_function.h"
#include "core/signals/npz.h"
#include "core/signals/rollout.h"
#include "core/text/number_text.h"
#include "core/text/text.h"
#include "core/values_of_state.h"

namespace surefoot {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double kLongest = 3600.0;  // [s]
constexpr std::int64_t kMostSteps = 1'000'000;

/// The scenario and the settings that come on top of the file's configuration: of policy and environment.
Status change(const Registry& registry, const RolloutRequest& r, Configuration& c) {
  if (r.scenario) {
    const auto scenario = findScenario(registry, c.names.environment, *r.scenario);
    if (!scenario) return scenario.error();
    for (const auto& [key, value] : (*scenario)->values)
      if (c.parameters.find(key))
        if (const Status s = c.parameters.set(key, value); !s) return s;
    c.names.scenario = *r.scenario;
  }
  const auto assignments = parseAssignments(r.assignments);
  if (!assignments) return assignments.error();
  if (const Status s = checkPolicyKeys(registry, r.policy, *assignments); !s) return s;
  for (const Assignment& a : *assignments) {
    if (!a.key.starts_with("policy.") && !a.key.starts_with("environment."))
      return Error{fmt::format("{}: nothing is learned here; only parameters of policy and environment can be set.",
                               shortened(a.key))};
    if (const Status s = c.parameters.set(a.key, std::string_view(a.value)); !s) return s;
  }
  c.names.policy = r.policy;
  return Done{};
}

/// "2.5:0.3"
Result<TimedPush> parsePush(const std::string& text) {
  const auto colon = text.find(':');
  const auto bad = [&] {
    return Error{
        fmt::format("--push: \"{}\" is not T:IMPULSE, a time from 0 to {:.0f} s and an impulse of at most "
                    "1000 N s, such as 2.5:0.3.",
                    shortened(text), kLongest)};
  };
  if (colon == std::string::npos) return bad();
  const auto time = parseNumber("--push", std::string_view(text).substr(0, colon));
  const auto impulse = parseNumber("--push", std::string_view(text).substr(colon + 1));
  if (!time || !impulse || !(*time >= 0 && *time <= kLongest) || !(std::abs(*impulse) <= 1000)) return bad();
  return TimedPush{*time, *impulse};
}

/// How long, where and with which pushes.
Result<RolloutSettings> settingsOf(const RolloutRequest& r, const Configuration& c, Environment& environment) {
  const Task& task = environment.task();
  RolloutSettings s;
  if (r.seed) {
    const auto seed = parseWhole("--seed", *r.seed, 0, ~std::uint64_t{0});
    if (!seed) return seed.error();
    s.seed = *seed;
  }
  if (r.episodes) {
    const auto episodes = parseCount("--episodes", *r.episodes, kMostSteps);
    if (!episodes) return episodes.error();
    s.episodes = *episodes;
  }
  if (r.seconds && !task.stepTime)
    return Error{fmt::format("--seconds: the environment {} has no clock; give --episodes.", c.names.environment)};
  double seconds = 25.0;
  if (r.seconds) {
    const auto value = parseNumber("--seconds", *r.seconds);
    if (!value || !(*value > 0 && *value <= kLongest))
      return Error{
          fmt::format("--seconds: \"{}\" is no time above 0 s and up to {:.0f} s.", shortened(*r.seconds), kLongest)};
    seconds = *value;
  }
  const bool timed = task.stepTime && (r.seconds || !r.episodes);
  s.steps = timed ? std::llround(seconds / *task.stepTime) : kMostSteps;
  if (!timed && !s.episodes) s.episodes = 10;
  if (r.state) {
    auto state = parseState("--state", *r.state, task);
    if (!state) return state.error();
    if (const Status ok = checkState(task, *state); !ok) return ok.error();
    if (!environment.place(*state)) return Error{"--state: this environment begins only where it always does."};
    s.start = std::move(*state);
  }
  for (const std::string& text : r.pushes) {
    const auto push = parsePush(text);
    if (!push) return push.error();
    if (!environment.push(0.0))
      return Error{fmt::format("--push: the environment {} has no body to push.", c.names.environment)};
    s.pushes.push_back(*push);
  }
  std::stable_sort(s.pushes.begin(), s.pushes.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  const Parameters::Entry* discount = c.parameters.find("agent.discount");
  s.discount = discount ? discount->value : 1.0;
  return s;
}

Result<std::string> asNpz(const Rollout& rollout) {
  std::vector<NamedArray> arrays;
  for (std::size_t i = 0; i < rollout.table.signals().size(); ++i)
    arrays.push_back({rollout.table.signals()[i].key, rollout.table.columns()[i]});
  return npzOf(arrays);
}

std::string hashOf(const Rollout& rollout) {
  Hash64 hash;
  for (const auto& column : rollout.table.columns())
    for (const double value : column) hash.add(std::isnan(value) ? 0.0 : value);
  return fmt::format("{:016x}", hash.value());
}

OrderedJson asJson(const Rollout& rollout, const RolloutRequest& r, const Configuration& c, const Task& task) {
  OrderedJson json = {{"file", r.file},
                      {"environment", c.names.environment},
                      {"scenario", c.names.scenario},
                      {"policy", c.names.policy},
                      {"steps", rollout.steps}};
  if (task.stepTime) json["seconds"] = static_cast<double>(rollout.steps) * *task.stepTime;
  json["episodes"] = rollout.episodes;
  json["falls"] = rollout.falls;
  json["successes"] = rollout.successes;
  json["reward"] = rollout.reward;
  for (std::size_t m = 0; m < task.measures.size(); ++m) json[task.measures[m].key] = rollout.measures[m];
  json["strides"] = asJson(stridesOf(rollout.table));
  json["signals"] = OrderedJson::array();
  for (const Signal& s : rollout.table.signals())
    json["signals"].push_back({{"key", s.key},
                               {"title", s.title},
                               {"symbol", s.symbol},
                               {"unit", s.unit},
                               {"group", s.group},
                               {"kind", s.kind == Signal::Kind::OnOff ? "on/off" : "number"}});
  json["hash"] = hashOf(rollout);
  return json;
}

std::string asTable(const Rollout& rollout, const Task& task) {
  std::string text;
  const auto row = [&](const std::string& what, double value, const std::string& unit = "") {
    text += fmt::format("{:<24}{:.6g}{}\n", what, value, unit.empty() ? "" : " " + unit);
  };
  row("steps", static_cast<double>(rollout.steps));
  if (task.stepTime) row("simulated seconds", static_cast<double>(rollout.steps) * *task.stepTime);
  row("episodes", static_cast<double>(rollout.episodes));
  if (task.canFall) row("falls", static_cast<double>(rollout.falls));
  if (task.goalReward) row("successes", static_cast<double>(rollout.successes));
  row("reward", rollout.reward);
  for (std::size_t m = 0; m < task.measures.size(); ++m)
    row(task.measures[m].title, rollout.measures[m], task.measures[m].unit);
  text += asLines(stridesOf(rollout.table));
  return text + fmt::format("{:<24}{}\n", "hash", hashOf(rollout));
}

}  // namespace

int rolloutCommand(const Registry& registry, const RolloutRequest& request) {
  auto f = openFunction(registry, request.file);
  if (!f) return fail(f.error());
  Configuration& c = f->configuration;
  if (const Status s = change(registry, request, c); !s) return fail(s.error());
  const auto environment = makeEnvironment(registry, c);
  if (!environment) return fail(environment.error());
  const auto policy = makePolicy(registry, c.names.policy, c.parameters);
  if (!policy) return fail(policy.error());
  const Task& task = (*environment)->task();
  if (const Status s = (*policy)->caution().check(usableBy(f->values(), task.handMade, true)); !s)
    return fail(s.error());
  (*policy)->advance({});
  auto settings = settingsOf(request, c, **environment);
  if (!settings) return fail(settings.error());

  std::optional<WholeFile> csv, npz;  // claimed before anything is lived
  for (const auto& [option, path, file] : {std::tuple{"--csv", &request.csv, &csv}, {"--npz", &request.npz, &npz}}) {
    if (!*path) continue;
    auto created = WholeFile::createNew(option, **path);
    if (!created) return fail(created.error());
    file->emplace(std::move(*created));
  }
  const auto film = RolloutFilm::prepare(request, **environment, f->values().hasRisk(), *settings);
  if (!film) return fail(film.error());
  const std::atomic<bool>& interrupted = watchForInterrupt();
  const Rollout rollout = rollOut(**environment, f->values(), **policy, *settings, &interrupted);
  if (interrupted) return fail({"interrupted; nothing is written.", ErrorKind::Interrupted});
  if (!rollout.stopped.empty()) return fail({rollout.stopped, ErrorKind::Unanswered});
  if (*film)
    if (const Status s = (*film)->make(rollout); !s) return fail(s.error());
  if (csv)
    if (const Status s = csv->commit(rollout.table.asCsv()); !s) return fail(s.error());
  if (npz) {
    const auto bytes = asNpz(rollout);
    if (!bytes) return fail(bytes.error());
    if (const Status s = npz->commit(*bytes); !s) return fail(s.error());
  }
  return print(request.json ? jsonText(asJson(rollout, request, c, task)) + "\n" : asTable(rollout, task));
}

}  // namespace surefoot
