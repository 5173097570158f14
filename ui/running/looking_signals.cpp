// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Looking that writes signals down and lives roll-outs.
#include <algorithm>
#include <cmath>

#include "ui/language/from_core.h"
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
  const Playback* p = playback();
  const std::int64_t shown = p ? p->frames[static_cast<std::size_t>(p->position)].row : shown_.row;
  const std::int64_t row = shown - (p ? p->firstRow : feed_.first());
  if (shown < 0 || row < 0 || row >= static_cast<std::int64_t>(signals().rows())) return std::nullopt;
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
  if (!hasViewer())
    return Error{QObject::tr("A program moves this robot; surefoot rollout lives what its Q-function has learned.")
                     .toStdString()};
  if (!life_.values()) return Error{QObject::tr("Nothing has been learned yet that could be lived.").toStdString()};
  const bool kept = copyable();
  std::shared_ptr<const ActionValueFunction> values =
      kept ? life_.values()->values->clone()
           : std::shared_ptr<const ActionValueFunction>(std::shared_ptr<void>(), life_.values()->values.get());
  Playback playback = rolloutOf(life_.registry(), life_.configuration(), std::move(values), seconds, 1);
  if (playback.frames.empty()) return Error{QObject::tr("This environment cannot be lived in here.").toStdString()};
  if (!kept) playback.values.reset();
  begin(std::move(playback));
  Q_EMIT playbackChanged();
  return Done{};
}

void Looking::wentOn() {
  recording_.clear();
  feed_.end();
  backToLive();
}

void Looking::askForEpisodeInHand() {
  inHand_ = std::make_shared<InHand>();
  life_.visit([to = inHand_](const Life& life) {
    to->inputs = life.inputs();
    to->begun = life.steps() - static_cast<std::int64_t>(life.inputs().actions.size() - life.inputs().before);
    to->ready = true;
  });
}

/// Of the last minutes: the episode in hand, or one that ended in a fall.
Result<EpisodeInputs> Looking::recordedMoment() const {
  const auto row = signalRow();
  if (feedOfViewer_ || !row || playback_->signals.rows() == 0)
    return Error{tr("Only the learner's own world can be gone on with, in the Signals layout and without turbo; or a "
                    "fall, or a roll-out.")
                     .toStdString()};
  const double stepTime = life_.task().stepTime.value_or(1.0);
  const auto lived = std::llround(playback_->signals.columns()[0][*row] / stepTime);
  for (const Fall& fall : seen_.falls) {
    const auto length = static_cast<std::int64_t>(fall.inputs.actions.size() - fall.inputs.before);
    if (lived >= fall.lifeSteps || lived < fall.lifeSteps - length) continue;
    EpisodeInputs until = fall.inputs;
    until.keepFirst(static_cast<std::size_t>(lived - fall.lifeSteps + std::ssize(fall.inputs.actions)));
    return until;
  }
  if (inHand_ && inHand_->ready && lived >= inHand_->begun) {
    EpisodeInputs until = inHand_->inputs;
    const auto step = static_cast<std::size_t>(lived - inHand_->begun) + until.before;
    if (step < until.actions.size()) until.keepFirst(step);
    return until;
  }
  return Error{tr("That episode is over, and it did not end in a fall: its inputs were not kept.").toStdString()};
}

Result<EpisodeInputs> Looking::momentShown() const {
  if (!playback_) return Error{tr("Nothing is shown again: open a fall, look back, or roll out first.").toStdString()};
  if (!playback_->start) return recordedMoment();
  const Parameters& now = life_.configuration().parameters;
  for (const auto& [key, value] : *playback_->start->parameters)
    if (const Parameters::Entry* entry = now.find(key); entry && entry->value != value)
      return Error{tr("%1 was %2 then and is %3 now: the same inputs would lead elsewhere.")
                       .arg(QString::fromStdString(key), valueText(entry->parameter, value),
                            valueText(entry->parameter, entry->value))
                       .toStdString()};
  EpisodeInputs until = playback_->start->inputs;
  const std::int64_t step = playback_->frames[static_cast<std::size_t>(playback_->position)].row;
  if (step < 0 || step >= std::ssize(until.actions))
    return Error{tr("The episode was over then; choose a moment before its end.").toStdString()};
  until.keepFirst(static_cast<std::size_t>(step));
  return until;
}

void Looking::setSecond(std::shared_ptr<const ActionValueFunction> values, const QString& name, const QString& path) {
  second_ = std::move(values);
  secondName_ = name;
  secondPath_ = path;
  secondSignals_ =
      playback_ && second_ ? besideOf(*playback_, life_.registry(), life_.configuration(), *second_) : SignalTable();
  Q_EMIT signalsReplaced();
}

void Looking::begin(Playback playback) {
  playback_ = std::move(playback);
  setSecond(second_, QString(secondName_), QString(secondPath_));
}

}  // namespace surefoot
