// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <thread>

#include "app/requests/requests.h"
#include "app/requests/train_from.h"
#include "app/requests/train_load.h"
#include "core/saved/q_file.h"
#include "core/saved/teacher_file.h"
#include "core/text/number_text.h"
#include "core/text/text.h"

namespace surefoot {

namespace {

/// STEP:KEY=VALUE
Result<std::vector<CommandText>> parseCommands(const std::vector<std::string>& texts) {
  std::vector<CommandText> commands;
  for (const std::string& text : texts) {
    const auto colon = text.find(':'), equals = text.find('=');
    std::int64_t step = -1;
    if (colon != std::string::npos && equals != std::string::npos && colon < equals && equals > colon + 1) {
      const auto steps = parseWhole("--at", std::string_view(text).substr(0, colon), 0, 1'000'000'000'000);
      if (steps) step = static_cast<std::int64_t>(*steps);
    }
    if (step < 0)
      return Error{
          fmt::format("--at: \"{}\" is not STEP:KEY=VALUE, such as 5000:policy.epsilon=0.1, with a whole number of "
                      "steps from 0 to 1000000000000.",
                      shortened(text))};
    commands.push_back({step, text.substr(colon + 1, equals - colon - 1), text.substr(equals + 1)});
  }
  std::stable_sort(commands.begin(), commands.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  return commands;
}

/// How long a life is, how many there are, and the seed.
Status readExtent(const TrainOptions& o, Configuration& c) {
  const auto real = [](const char* option, const std::optional<std::string>& text, const char* unit, double low,
                       double high, std::optional<double>& member) -> Status {
    if (!text) return Done{};
    const Parameter parameter{.key = option, .unit = unit, .low = low, .high = high};
    const auto value = parseValue(parameter, *text);
    if (!value) return value.error();
    member = *value;
    return Done{};
  };
  if (const Status s = real("--minutes", o.minutes, "min", 0.001, 1e6, c.minutes); !s) return s;
  if (const Status s = real("--until", o.until, "", -1e9, 1e9, c.until); !s) return s;
  if (o.seed) {
    const auto seed = parseSeed("--seed", *o.seed);
    if (!seed) return seed.error();
    c.seed = *seed;
  }
  if (o.episodes) {
    const auto value = parseCount("--episodes", *o.episodes, 1'000'000'000);
    if (!value) return value.error();
    c.episodes = *value;
  }
  const auto lives = o.lives ? parseCount("--lives", *o.lives, 1'000'000) : Result<std::int64_t>(1);
  if (!lives) return lives.error();
  c.lives = static_cast<int>(*lives);
  return Done{};
}

/// Files that hold one life.
Status checkOneLife(const TrainOptions& o, const Configuration& c) {
  if (c.lives == 1) return Done{};
  for (const auto& [name, option] : {std::pair{"--save", &o.save}, std::pair{"--journal", &o.journal},
                                     std::pair{"--checkpoint", &o.checkpoint}, std::pair{"--resume", &o.resume}})
    if (*option) return Error{fmt::format("{}: it is for one life, and --lives is {}.", name, c.lives)};
  return Done{};
}

/// No two results in one file.
Status checkDifferentFiles(const TrainOptions& o) {
  std::vector<std::pair<const char*, std::filesystem::path>> files;
  for (const auto& [name, option] : {std::pair{"--log", &o.log}, std::pair{"--save", &o.save},
                                     std::pair{"--journal", &o.journal}, std::pair{"--checkpoint", &o.checkpoint}}) {
    if (!*option || (*option)->empty()) continue;
    std::error_code failed;
    auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(**option, failed), failed);
    if (failed) path = std::filesystem::absolute(**option).lexically_normal();
    for (const auto& [other, taken] : files)
      if (taken == path)
        return Error{fmt::format("{}: {} is the file of {}, too; name another.", name, **option, other)};
    files.emplace_back(name, path);
  }
  return Done{};
}

/// An error for parameters that are given but have no effect, because the part that they belong to is off.
Status checkEffect(const Parameters& parameters, const std::vector<Assignment>& assignments) {
  for (const Assignment& a : assignments) {
    if (const Parameters::Entry* choice = parameters.idleBecauseOf(parameters.find(a.key)->parameter))
      return Error{fmt::format("{}: it has no effect while {} is {}.", a.key, choice->parameter.key,
                               formatValue(choice->parameter, choice->value))};
  }
  return Done{};
}

Status checkCheckpoint(const TrainOptions& o) {
  if (!o.checkpoint) return o.every ? Status(Error{"--every: it needs --checkpoint FILE."}) : Status(Done{});
  std::error_code ignored;
  if (o.resume && std::filesystem::equivalent(*o.resume, *o.checkpoint, ignored)) return Done{};
  if (!std::filesystem::exists(std::filesystem::symlink_status(*o.checkpoint, ignored))) return Done{};
  return Error{
      fmt::format("--checkpoint: {} exists already; name a file that does not, or go on from it with --resume.",
                  *o.checkpoint),
      ErrorKind::File};
}

/// [steps] between two checkpoints.
Result<std::int64_t> checkpointEvery(const TrainOptions& o, const Task& task) {
  constexpr std::int64_t kWithoutClock = 1'000'000;
  const Parameter every{.key = "--every", .unit = "min", .low = 0.001, .high = 1e6};
  const auto minutes = o.every ? parseValue(every, *o.every) : Result<double>(10.0);
  if (!minutes) return minutes.error();
  if (task.stepTime) return std::max<std::int64_t>(1, static_cast<std::int64_t>(*minutes * 60 / *task.stepTime));
  if (o.every)
    return Error{"--every: the environment has no clock; without --every a checkpoint is written every million steps."};
  return kWithoutClock;
}

/// An option that chooses a name although the file fixes the names; nullptr: none.
const char* namedOption(const TrainOptions& o) {
  if (o.names.environment) return "--environment";
  if (o.names.preset) return "--preset";
  if (o.names.scenario) return "--scenario";
  if (o.names.agent) return "--agent";
  if (o.names.features) return "--features";
  if (o.names.policy) return "--policy";
  return nullptr;
}

/// A life that goes on brings its configuration with it.
Status checkResume(const TrainOptions& o) {
  const auto other = [&]() -> const char* {
    if (const char* name = namedOption(o)) return name;
    if (o.from) return "--from";
    if (!o.assignments.empty()) return "--set";
    if (!o.at.empty()) return "--at";
    if (o.seed) return "--seed";
    if (o.load) return "--load";
    if (o.until) return "--until";
    return nullptr;
  }();
  if (!other) return Done{};
  return Error{
      fmt::format("{}: a life that goes on (--resume) does so under its own configuration; only --minutes and "
                  "--episodes may be longer.",
                  other)};
}

Result<TrainRequest> makeResumeRequest(const Registry& registry, const TrainOptions& o, TrainRequest request) {
  auto file = readQFile(*o.resume);
  if (!file) return file.error();
  request.limits = {request.configuration.minutes, request.configuration.episodes};
  if (const Status same = checkLivesVersion(**file); !same && !o.otherVersion) return orOtherVersion(same.error());
  request.versions = o.otherVersion ? Versions::Any : Versions::Same;
  // Resumes once as a test, so that a misfit is reported before the run.
  auto resumed = resume(registry, *file, request.limits, request.versions);
  if (!resumed) return resumed.error();
  if (request.log && !resumed->keepRows)
    return Error{
        fmt::format("--log: {} holds no rows of the episodes so far, because it was begun without --log.", *o.resume)};
  if ((request.limits.minutes || request.limits.episodes) && resumed->life->finished())
    return Error{
        fmt::format("--resume: the life is {} episodes and {} steps long already; --minutes or --episodes must be "
                    "longer than that.",
                    resumed->life->log().totals().episodes, resumed->life->steps())};
  const auto every = checkpointEvery(o, resumed->life->environment().task());
  if (!every) return every.error();
  request.checkpointEvery = *every;
  request.mayRewind = resumed->life->mayRewind();
  request.configuration = std::move(resumed->configuration);
  request.resumed = std::move(*file);
  return request;
}

/// The configuration from a file (--from, or else --load, `loaded`), or the one that options choose by name.
Result<LivedBefore> chosenConfiguration(const Registry& registry, const TrainOptions& o, const TensorFile* loaded,
                                        const std::vector<Assignment>& assignments) {
  if (!o.from) {
    auto configuration = loaded ? configurationUpon(registry, *loaded, o.names, assignments, o.loadFromOther)
                                : configure(registry, namesOr(o.names, {}), assignments);
    if (!configuration) return configuration.error();
    return LivedBefore{std::move(*configuration), {}};
  }
  if (const char* name = namedOption(o))
    return Error{fmt::format("{}: the file of --from says it; only parameters can be set on top.", name)};
  auto lived = readLivedBefore(registry, *o.from);
  if (!lived) return lived;
  for (const Assignment& a : assignments)
    if (const Status s = lived->configuration.parameters.set(a.key, std::string_view(a.value)); !s) return s.error();
  return lived;
}

/// What was learned on another model of the robot is told.
std::string originOf(const Registry& registry, const TensorFile& file, const Configuration& ours) {
  const auto theirs = configurationOf(registry, file);
  if (!theirs || theirs->names.environment == ours.names.environment) return "";
  return fmt::format("{}: learned on {}, and goes on on {}.", file.name, theirs->names.environment,
                     ours.names.environment);
}

}  // namespace

Result<TrainRequest> makeTrainRequest(const Registry& registry, const TrainOptions& o, bool window) {
  TrainRequest request{};
  request.json = o.json, request.turbo = o.turbo;
  request.log = o.log, request.save = o.save, request.journal = o.journal, request.checkpoint = o.checkpoint;

  if (o.loadFromOther && !o.load) return Error{"--load-from-other: it goes with --load FILE."};
  if (o.otherVersion && !o.resume) return Error{"--other-version: it goes with --resume FILE."};
  if (o.resume)
    if (const Status s = checkResume(o); !s) return s.error();
  auto assignments = parseAssignments(o.assignments);
  if (!assignments) return assignments.error();
  auto teacher = takeTeacher(*assignments, "");
  if (!teacher) return teacher.error();
  std::shared_ptr<const TensorFile> loaded;
  if (o.load) {
    auto file = readQFile(*o.load);
    if (!file) return file.error();
    loaded = std::move(*file);
  }
  auto chosen = chosenConfiguration(registry, o, loaded.get(), *assignments);
  if (!chosen) return chosen.error();
  Configuration& c = request.configuration = std::move(chosen->configuration);
  request.note = chosen->note;
  if (*teacher) c.teacher = std::move(*teacher);
  if (!window) {
    if (const Status s = checkPolicyKeys(registry, c.names.policy, *assignments); !s) return s.error();
    if (const Status s = checkEffect(c.parameters, *assignments); !s) return s.error();
  }
  if (loaded)
    for (const std::string& note : {originOf(registry, *loaded, c), riskNote(*loaded, c)})
      if (!note.empty()) request.note += (request.note.empty() ? "" : "\n") + note;
  if (const Status s = readExtent(o, c); !s) return s.error();
  if (const Status s = checkOneLife(o, c); !s) return s.error();
  if (const Status s = checkDifferentFiles(o); !s) return s.error();
  if (const Status s = checkCheckpoint(o); !s) return s.error();
  const std::int64_t cores = std::max(1u, std::thread::hardware_concurrency());
  const auto jobs = o.jobs ? parseCount("--jobs", *o.jobs, 1024) : Result<std::int64_t>(cores);
  if (!jobs) return jobs.error();
  request.jobs = static_cast<int>(*jobs);
  if (o.resume) return makeResumeRequest(registry, o, std::move(request));

  auto commands = parseCommands(o.at);
  if (!commands) return commands.error();
  c.commands.insert(c.commands.end(), commands->begin(), commands->end());
  std::stable_sort(c.commands.begin(), c.commands.end(), [](const auto& a, const auto& b) { return a.step < b.step; });
  if (loaded) beginWith(c, std::move(loaded));
  if (window && c.lives > 1)
    return Error{fmt::format("--lives: the window shows one life, not {}; `surefoot train` runs many.", c.lives)};
  if (!c.minutes && !c.episodes) request.mostSteps = chosen->steps;
  if (!window && !o.openEnded && !c.minutes && !c.episodes && !request.mostSteps)
    return Error{"--minutes or --episodes: how long a life is must be given, e.g. --minutes 9."};
  const auto life = makeLife(registry, c, 0, false);  // finds errors that no single check can see
  if (!life) return life.error();
  const auto every = checkpointEvery(o, (*life)->environment().task());
  if (!every) return every.error();
  request.checkpointEvery = *every;
  request.mayRewind = (*life)->mayRewind();
  return request;
}

}  // namespace surefoot
