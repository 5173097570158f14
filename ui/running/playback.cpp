// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/running/playback.h"

#include <QObject>
#include <algorithm>

#include "core/environment_library.h"
#include "core/parameters.h"
#include "core/text/text.h"

namespace surefoot {

namespace {
constexpr double kSeconds = 3.0;   // shown before a fall
constexpr double kSlow = 0.5;      // share of real time
constexpr double kNoClock = 0.05;  // time of a step in a task without a clock [s]
}  // namespace

Playback playbackOf(const Fall& fall, const Registry& registry, const std::string& environment,
                    std::shared_ptr<const ActionValueFunction> values) {
  const auto entry = findEnvironment(registry, environment);
  if (!entry) return {};
  const auto world = (*entry)->make();
  if (!world->answersAtOnce()) return {};
  Fields fields("environment.");
  world->declare(fields);
  for (const auto& [key, value] : *fall.parameters)
    for (const auto& field : fields.all())
      if (field.parameter.key == key) field.set(value);
  world->parametersChanged();

  Playback playback;
  playback.values = std::move(values);
  playback.title = QObject::tr("fall %1, episode %2, at half speed")
                       .arg(QString::fromStdString(countText(static_cast<double>(fall.number))),
                            QString::fromStdString(countText(static_cast<double>(fall.episode))));
  const std::size_t n = world->task().actions.size();
  Ending ending = Ending::None;
  Random random(0);
  const bool whole = repeat(fall.inputs, *world, random, ending, [&](Action next) {
    Shown frame;
    frame.state.assign(world->state().begin(), world->state().end());
    frame.pose = world->pose();
    frame.action = next;
    const std::size_t step = playback.frames.size();
    if (fall.inputs.explored.size() == fall.inputs.actions.size() && step < fall.inputs.explored.size())
      frame.explores = fall.inputs.explored[step] != 0;
    frame.q.resize(n);
    if (playback.values) {
      playback.values->evaluate(frame.state, Layer::Sum, frame.q);
      frame.risk.resize(playback.values->hasRisk() ? n : 0);
      if (playback.values->hasRisk()) playback.values->evaluate(frame.state, Layer::Risk, frame.risk);
      if (playback.values->split()) {
        frame.qPositive.resize(n), frame.qNegative.resize(n);
        playback.values->evaluate(frame.state, Layer::Positive, frame.qPositive);
        playback.values->evaluate(frame.state, Layer::Negative, frame.qNegative);
      }
    }
    playback.frames.push_back(std::move(frame));
  });
  if (!whole || playback.frames.empty()) return {};
  playback.frames.back().flash = true;
  const double step = world->task().stepTime.value_or(kNoClock);
  const auto last = static_cast<std::size_t>(kSeconds / step);
  if (playback.frames.size() > last)
    playback.frames.erase(playback.frames.begin(), playback.frames.end() - static_cast<std::ptrdiff_t>(last));
  playback.rate = playback.usualRate = kSlow / step;
  return playback;
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

}  // namespace surefoot
