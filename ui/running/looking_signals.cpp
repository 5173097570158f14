// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Looking that writes signals down and lives roll-outs.
#include <algorithm>

#include "ui/running/looking.h"

namespace surefoot {

void Looking::watchSignals(const QObject* who, bool watches) {
  watches ? static_cast<void>(watching_.insert(who)) : static_cast<void>(watching_.erase(who));
  life_.wantSteps(!watching_.empty());
  if (!watching_.empty()) return;
  viewer_->writeTo(nullptr);
  feed_.end();
}

/// Called before the viewer lives on, or after a moment of the learner's world has come.
void Looking::writeSignals(bool viewing) {
  if (watching_.empty()) return;
  const Snapshot& now = life_.snapshot();
  const bool hasRisk = viewing ? life_.values()->values->hasRisk() : !now.risk.empty();
  if (!feed_.on() || feedOfViewer_ != viewing || feed_.hasRisk() != hasRisk) {
    const Parameters::Entry* discount = life_.configuration().parameters.find("agent.discount");
    feed_.begin(life_.environment(), hasRisk, discount ? discount->value : 1.0);
    feedOfViewer_ = viewing;
    Q_EMIT signalsReplaced();
  }
  viewer_->writeTo(viewing ? &feed_ : nullptr);
  if (!viewing) feed_.see(now, viewer_->policy());
}

std::optional<std::size_t> Looking::signalRow() const {
  const std::int64_t row = shown_.row - (playback_ ? playback_->firstRow : feed_.first());
  if (shown_.row < 0 || row < 0 || row >= static_cast<std::int64_t>(signals().rows())) return std::nullopt;
  return static_cast<std::size_t>(row);
}

void Looking::seekRow(std::size_t row) {
  if (!playback_) lookBack(-1);
  if (!playback_) return;
  const std::int64_t wanted = playback_->firstRow + static_cast<std::int64_t>(row);
  const auto& frames = playback_->frames;
  const auto at = std::find_if(frames.begin(), frames.end(), [&](const Shown& f) { return f.row >= wanted; });
  playback_->rate = 0;
  seek(static_cast<double>(std::min<std::ptrdiff_t>(at - frames.begin(), std::ssize(frames) - 1)));
}

Status Looking::rollOut(double seconds) {
  if (!hasViewer()) return Error{"A program moves this robot; surefoot rollout lives what its Q-function has learned."};
  if (!life_.values()) return Error{"Nothing has been learned yet that could be lived."};
  const bool kept = copyable();
  std::shared_ptr<const ActionValueFunction> values =
      kept ? life_.values()->values->clone()
           : std::shared_ptr<const ActionValueFunction>(std::shared_ptr<void>(), life_.values()->values.get());
  Playback playback = rolloutOf(life_.registry(), life_.configuration(), std::move(values), seconds, 1);
  if (playback.frames.empty()) return Error{"This environment cannot be lived in here."};
  if (!kept) playback.values.reset();
  begin(std::move(playback));
  Q_EMIT playbackChanged();
  return Done{};
}

void Looking::setSecond(std::shared_ptr<const ActionValueFunction> values, const QString& name) {
  second_ = std::move(values);
  secondName_ = name;
  secondSignals_ =
      playback_ && second_ ? besideOf(*playback_, life_.registry(), life_.configuration(), *second_) : SignalTable();
  Q_EMIT signalsReplaced();
}

void Looking::begin(Playback playback) {
  playback_ = std::move(playback);
  setSecond(second_, secondName_);
}

}  // namespace surefoot
