// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/new_lives.h"

#include <chrono>
#include <new>

#include "core/environment_library.h"
#include "core/saved/carry_over.h"
#include "core/saved/q_file.h"

namespace surefoot {

namespace {
/// The window may wait this long for a table, so that tables of usual size are ready at once.
constexpr std::chrono::milliseconds kPatience(100);
}  // namespace

NewLives::NewLives(RunningLife& life, History& history) : life_(life), history_(history) {
  connect(&background_, &Background::failed, this, &NewLives::refused);
}

NewLives::Make NewLives::makeOf(Configuration configuration) const {
  return [&registry = life_.registry(), keepRows = life_.keepsRows(),
          configuration = std::move(configuration)](const std::atomic<bool>&) -> Result<Made> {
    auto life = makeLifeToRun(registry, configuration, keepRows);
    if (!life) return life.error();
    return Made{configuration, std::move(*life)};
  };
}

Status NewLives::whenMade(Make make, Adopt adopt, const Then& then) {
  struct Work {
    Result<Made> made = Error{"cancelled"};
    bool returned = false;
    Status status = Done{};
  };
  const auto work = std::make_shared<Work>();
  const auto finish = [this, work, adopt = std::move(adopt), then] {
    work->status = work->made ? adopt(std::move(*work->made)) : Status(work->made.error());
    if (then) return then(work->status);
    if (work->returned && !work->status) Q_EMIT refused(QString::fromStdString(work->status.error().message));
  };
  background_.start(
      [work, make = std::move(make)](const std::atomic<bool>& interrupted) { work->made = make(interrupted); },
      [this, work, finish] { work->made ? history_.endOrAsk(finish) : finish(); }, kPatience);
  work->returned = true;
  return work->status;
}

Status NewLives::beginWhenMade(Make make, const Then& then) {
  return whenMade(
      std::move(make), [this](Made made) { return adopt(std::move(made)); }, then);
}

KnownLife NewLives::known(const Made& made) const {
  Configuration now = made.configuration;
  now.commands.clear();
  now.parameters = made.life->parameters();
  now.names.policy = made.life->policyName();
  KnownLife known = knownAs(life_.registry(), std::move(now), made.configuration);
  known.last = made.last;
  if (made.file) known.file = *made.file;
  return known;
}

Status NewLives::adopt(Made made) {
  KnownLife next = known(made);  // needs the life, so it comes first
  history_.replace(std::move(next), std::move(made.life), History::As::Another);
  if (!made.remark.empty()) Q_EMIT remarked(QString::fromStdString(made.remark));
  return Done{};
}

Status NewLives::beginAgain(Configuration configuration) {
  return whenMade(makeOf(std::move(configuration)), [this](Made made) -> Status {
    KnownLife known = life_.known();
    known.file = {};
    known.falls = 0;
    known.began = known.configuration = std::move(made.configuration);
    history_.replace(std::move(known), std::move(made.life), History::As::SameAgain);
    return Done{};
  });
}

Status NewLives::restart() {
  return beginAgain(life_.configuration());
}

Status NewLives::restartEmpty() {
  Configuration empty = life_.configuration();
  empty.start.reset();
  empty.beganWith = {};
  return beginAgain(std::move(empty));
}

Status NewLives::setParameterAndRestart(const std::string& key, double value) {
  Configuration changed = life_.configuration();
  if (const Status s = changed.parameters.set(key, value); !s) return s;
  return beginAgain(std::move(changed));
}

Status NewLives::begin(Configuration configuration) {
  return beginWhenMade(makeOf(std::move(configuration)));
}

Status NewLives::beginEnvironment(const std::string& name) {
  Names names;
  names.environment = name;
  names.policy = life_.configuration().names.policy;
  auto configuration = configure(life_.registry(), names, {});
  if (!configuration) return configuration.error();
  configuration->seed = life_.configuration().seed;
  return begin(std::move(*configuration));
}

Status NewLives::setSeed(std::uint64_t seed) {
  Configuration changed = life_.configuration();
  changed.seed = seed;
  return begin(std::move(changed));
}

Status NewLives::setAgent(const std::string& name) {
  Names names = life_.configuration().names;
  if (name == names.agent) return Done{};
  names.agent = name;
  auto changed = configurationUnder(life_.registry(), life_.configuration(), names);
  return changed ? begin(std::move(*changed)) : Status(changed.error());
}

namespace {

/// Input and result of carrying a Q-function over.
struct CarriedOver {
  std::shared_ptr<const ActionValueFunction> from;
  Configuration to;
  Result<TensorFile> file = Error{"cancelled"};
};

Result<TensorFile> fitted(const Registry& registry, const CarriedOver& work, const std::atomic<bool>& interrupted) {
  const auto environment = makeEnvironment(registry, work.to);
  if (!environment) return environment.error();
  const Task& task = (*environment)->task();
  const auto entry = findEntry(registry.agents, "agent", work.to.names.agent);
  if (!entry) return entry.error();
  try {
    auto agent = (*entry)->make({task, work.to.names.features, work.to.parameters, 0});
    if (!agent) return agent.error();
    carryOver(*work.from, **agent, task, &interrupted);
    return qFileOf(**agent, task, work.to, Json{{"carried_over", true}});
  } catch (const std::bad_alloc&) {
    return Error{QObject::tr("There is not enough memory for this; take fewer tiles or tilings.").toStdString()};
  }
}

}  // namespace

void NewLives::carryOver(const std::string& key, double value, Then then) {
  auto work = std::make_shared<CarriedOver>();
  work->to = life_.configuration();
  if (const Status s = work->to.parameters.set(key, value); !s) return then(s);
  const auto end = [this, work, then] {
    if (!work->file) return then(work->file.error());
    beginWith(work->to, std::make_shared<const TensorFile>(std::move(*work->file)));
    then(begin(std::move(work->to)));
  };
  const auto fit = [this, work, end] {
    background_.start([work, &registry = life_.registry()](
                          const std::atomic<bool>& interrupted) { work->file = fitted(registry, *work, interrupted); },
                      end);
  };
  life_.visit([this, work, fit](const Life& life) {  // a copy of the learned values
    work->from = life.agent().values().clone();
    calls_.post(fit);
  });
}

}  // namespace surefoot

#include "moc_new_lives.cpp"
