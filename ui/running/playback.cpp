// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/playback.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "core/environment_library.h"
#include "core/parameters.h"
#include "ui/language/numbers.h"

namespace surefoot {

namespace {

constexpr double kSeconds = 3.0;   // played before a fall
constexpr double kLongest = 60.0;  // kept before a fall [s]
constexpr double kSlow = 0.5;      // share of real time

/// The poses of frames alone; their rows count from `firstRow` on.
template <class Frames>
Footage posesOf(const Frames& frames, double rate, std::int64_t firstRow) {
  Footage footage{.poses = {}, .falls = {}, .rows = {}, .rate = rate};
  for (const Shown& frame : frames) {
    footage.poses.push_back(frame.pose);
    footage.falls.push_back(frame.flash);
    footage.rows.push_back(frame.row < firstRow ? -1 : frame.row - firstRow);
  }
  return footage;
}

double stepTimeOf(const Environment& world) {
  return world.task().stepTime.value_or(kUnclockedStep);
}

/// A world with the parameters of then; nullptr: there is none, or it takes its time.
std::unique_ptr<Environment> worldOf(const Fall& fall, const Registry& registry, const std::string& environment) {
  const auto entry = findEnvironment(registry, environment);
  if (!entry) return nullptr;
  auto world = (*entry)->make();
  if (!world->answersAtOnce()) return nullptr;
  Fields fields("environment.");
  world->declare(fields);
  for (const auto& [key, value] : *fall.parameters)
    for (const auto& field : fields.all())
      if (field.parameter.key == key) field.set(value);
  world->parametersChanged();
  return world;
}

/// Adds a frame to a playback for every row of its signals. While the next episode has begun already, the fallen body
/// is seen for a moment, as in the window.
SeeMoment filming(Playback& playback) {
  return [&playback, fallen = std::vector<double>(), until = std::int64_t{0}](const RolloutMoment& m) mutable {
    const Environment& world = m.environment;
    const auto row = static_cast<std::int64_t>(playback.frames.size());
    if (m.fell)
      fallen = world.pose(), until = row + std::max<std::int64_t>(1, std::llround(kFallShown / stepTimeOf(world)));
    if (m.row < row) return;
    Shown frame;
    frame.state.assign(world.state().begin(), world.state().end());
    frame.flash = row < until;
    frame.pose = frame.flash ? fallen : world.pose();
    frame.action = m.next;
    frame.q = m.here.q;
    frame.risk = m.here.risk;
    frame.q.resize(world.task().actions.size());
    if (playback.values && playback.values->split()) {
      frame.qPositive.resize(frame.q.size()), frame.qNegative.resize(frame.q.size());
      playback.values->evaluate(frame.state, Layer::Positive, frame.qPositive);
      playback.values->evaluate(frame.state, Layer::Negative, frame.qNegative);
    }
    frame.row = row;
    playback.frames.push_back(std::move(frame));
  };
}

double discountOf(const Configuration& c) {
  const Parameters::Entry* discount = c.parameters.find("agent.discount");
  return discount ? discount->value : 1.0;
}

}  // namespace

Playback playbackOf(const Fall& fall, const Registry& registry, const Configuration& configuration,
                    std::shared_ptr<const ActionValueFunction> values) {
  const auto world = worldOf(fall, registry, configuration.names.environment);
  const auto policy = makePolicy(registry, configuration.names.policy, configuration.parameters);
  if (!world || !policy) return {};
  Playback playback;
  playback.values = std::move(values);
  playback.title =
      QObject::tr("fall %1, episode %2, at half speed")
          .arg(countNumber(static_cast<double>(fall.number)), countNumber(static_cast<double>(fall.episode)));
  playback.signals =
      relive(*world, fall.inputs, playback.values.get(), **policy, discountOf(configuration), filming(playback));
  if (playback.signals.rows() == 0 || playback.frames.empty()) return {};
  playback.start = std::make_shared<const Fall>(fall);
  const auto& explored = fall.inputs.explored;
  if (explored.size() == fall.inputs.actions.size())
    for (std::size_t step = 0; step < explored.size(); ++step) playback.frames[step].explores = explored[step] != 0;
  const double step = stepTimeOf(*world);
  const auto most = static_cast<std::size_t>(kLongest / step);
  if (const std::size_t all = playback.frames.size(); all > most) {
    playback.frames.erase(playback.frames.begin(), playback.frames.end() - static_cast<std::ptrdiff_t>(most));
    playback.signals.dropFirst(all - most);
    playback.firstRow = static_cast<std::int64_t>(all - most);
  }
  const double last = static_cast<double>(playback.frames.size()) - 1.0;
  playback.position = playback.begin = std::max(0.0, last - std::floor(kSeconds / step) + 1.0);
  playback.realRate = 1.0 / step;
  playback.rate = playback.usualRate = kSlow / step;
  return playback;
}

Playback rolloutOf(const Registry& registry, const Configuration& configuration,
                   std::shared_ptr<const ActionValueFunction> values, double seconds, std::uint64_t seed) {
  const auto world = makeEnvironment(registry, configuration);
  const auto greedy = makePolicy(registry, "greedy", configuration.parameters);
  if (!world || !greedy || !(*world)->answersAtOnce()) return {};
  Fall start;
  start.inputs.random = Random(deriveSeed(seed, 0, Stream::World)).state();
  std::vector<std::pair<std::string, double>> parameters;
  for (const auto& entry : configuration.parameters.all())
    if (entry.parameter.key.starts_with("environment.")) parameters.emplace_back(entry.parameter.key, entry.value);
  start.parameters = std::make_shared<const decltype(parameters)>(std::move(parameters));
  Playback playback;
  playback.values = std::move(values);
  const double step = stepTimeOf(**world);
  playback.signals = rollOut(**world, *playback.values, **greedy,
                             {.seed = seed,
                              .steps = std::llround(seconds / step),
                              .discount = discountOf(configuration),
                              .see = filming(playback)})
                         .table;
  if (playback.frames.empty()) return {};
  const std::vector<double>&action = *playback.signals.column("action"), &episode = *playback.signals.column("episode");
  for (std::size_t row = 0; row < action.size() && episode[row] == 1.0; ++row)
    start.inputs.actions.push_back(static_cast<std::uint16_t>(action[row]));
  playback.start = std::make_shared<const Fall>(std::move(start));
  playback.title = QObject::tr("roll-out, greedy, seed %1").arg(seed);
  playback.rate = playback.usualRate = playback.realRate = 1.0 / step;
  return playback;
}

SignalTable besideOf(const Playback& playback, const Registry& registry, const Configuration& configuration,
                     const ActionValueFunction& values) {
  const auto world = playback.start ? worldOf(*playback.start, registry, configuration.names.environment) : nullptr;
  const auto greedy = makePolicy(registry, "greedy", configuration.parameters);
  if (!world || !greedy) return {};
  const auto steps = playback.firstRow + static_cast<std::int64_t>(playback.frames.size());
  SignalTable table = rollOut(*world, values, **greedy,
                              {.steps = steps, .discount = discountOf(configuration), .as = &playback.start->inputs})
                          .table;
  table.dropFirst(static_cast<std::size_t>(playback.firstRow));
  return table;
}

Footage footageOf(const Playback& playback) {
  Footage footage = posesOf(playback.frames, playback.realRate, playback.firstRow);
  const auto last = std::find(footage.falls.rbegin(), footage.falls.rend(), 0) - footage.falls.rbegin();
  if (last == 0) return footage;
  for (auto more = static_cast<std::int64_t>(kFallShown * playback.realRate) + 1 - last; more > 0; --more) {
    footage.poses.push_back(std::vector<double>(footage.poses.back()));
    footage.falls.push_back(1);
    footage.rows.push_back(footage.rows.back());
  }
  return footage;
}

void Recording::add(const Shown& frame) {
  frames_.push_back(frame);
  const std::size_t bytes =
      sizeof(Shown) + sizeof(double) * (frame.state.size() + frame.pose.size() + 3 * frame.q.size());
  const std::size_t most = std::min(kMostFrames, kMostBytes / bytes);
  while (frames_.size() > most) frames_.pop_front();
}

Playback Recording::playback() const {
  Playback p;
  p.frames.assign(frames_.begin(), frames_.end());
  p.position = p.frames.empty() ? 0.0 : static_cast<double>(p.frames.size()) - 1.0;
  p.title = QObject::tr("the last minutes");
  return p;
}

Footage Recording::footage(std::int64_t firstRow) const {
  return posesOf(frames_, Playback().realRate, firstRow);
}

}  // namespace surefoot
