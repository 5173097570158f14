// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Looking that replays falls and the last minutes.
#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/controls/preferences.h"
#include "ui/running/looking.h"

namespace surefoot {

void Looking::takeFalls() {
  constexpr std::size_t kMostValues = 20;
  std::vector<Fall> fresh = std::exchange(fallsToCome_, {});
  for (Fall& fall : life_.takeFalls()) fresh.push_back(std::move(fall));
  // The learner is ahead of the window: a fall is listed only when the window's counter has reached its number.
  const auto ahead =
      std::find_if(fresh.begin(), fresh.end(), [this](const Fall& f) { return f.number > life_.numbers().falls; });
  fallsToCome_.assign(std::move_iterator(ahead), std::move_iterator(fresh.end()));
  fresh.erase(ahead, fresh.end());
  if (fresh.empty()) return;
  // Keeps the values that the window had nearest to the fall. In turbo there are hundreds of falls per second.
  constexpr int kEvery = 500;  // [ms]
  if (copyable() && (!sinceValues_.isValid() || sinceValues_.elapsed() >= kEvery)) {
    sinceValues_.start();
    seen_.values.emplace_back(fresh.back().number, life_.values()->values->clone());
  }
  if (seen_.values.size() > kMostValues) seen_.values.pop_front();
  for (Fall& fall : fresh) seen_.falls.push_back(std::move(fall));
  thinOut(seen_.falls);
  Q_EMIT fallsArrived();
}

void Looking::replayFall(std::size_t index) {
  if (showFall(index)) Q_EMIT fallReplayed(seen_.falls[index].episode);
}

void Looking::showLastFall() {
  if (seen_.falls.empty() || !showFall(seen_.falls.size() - 1) || !playback_) return;
  playback_->usualRate /= 2;
  playback_->rate /= 2;
  playback_->title = tr("fall %1, at a quarter of the speed").arg(seen_.falls.back().number);
  Q_EMIT playbackChanged();
}

bool Looking::showFall(std::size_t index) {
  if (index >= seen_.falls.size()) return false;
  const Fall& fall = seen_.falls[index];
  std::shared_ptr<const ActionValueFunction> then;
  for (const auto& [number, values] : seen_.values)
    if (number >= fall.number && !then) then = values;
  if (!then && copyable()) then = life_.values()->values->clone();
  const bool kept = then != nullptr;
  if (!kept && life_.values()) then = {std::shared_ptr<void>(), life_.values()->values.get()};  // for the frames only
  Playback playback = playbackOf(fall, life_.registry(), life_.configuration(), std::move(then));
  if (playback.frames.empty()) return false;
  if (!kept) playback.values.reset();
  if (reducedMotion()) {  // the playback stops at the fall; a person steps through it by hand
    playback.rate = 0;
    playback.position = static_cast<double>(playback.frames.size()) - 1;
  }
  begin(std::move(playback));
  Q_EMIT playbackChanged();
  return true;
}

bool Looking::copyable() const {
  constexpr std::size_t kMost = 16u << 20;  // [bytes]: a larger copy takes too long, and twenty copies too much memory
  return life_.values() && life_.values()->values->bytes() <= kMost;
}

void Looking::lookBack(int frames) {
  if (!playback_) {
    if (recording_.size() < 2 || frames > 0) return;
    Playback recorded = recording_.playback();
    recorded.signals = feed_.table();
    recorded.firstRow = feed_.first();
    askForEpisodeInHand();
    begin(std::move(recorded));
  }
  playback_->rate = 0;
  seek(playback_->position + frames);
}

void Looking::stepOnce() {
  if (playback_ && playback_->rate == 0) return lookBack(+1);
  life_.stepOnce();
}

void Looking::seek(double position) {
  if (!playback_) return;
  const double last = static_cast<double>(playback_->frames.size()) - 1.0;
  if (position > last + 0.5 && playback_->rate == 0) return backToLive();
  playback_->position = std::clamp(position, 0.0, last);
  Q_EMIT playbackChanged();
}

void Looking::play(bool on) {
  if (!playback_) return;
  if (on && playback_->atEnd()) playback_->position = playback_->begin;
  playback_->rate = on ? playback_->usualRate : 0;
  Q_EMIT playbackChanged();
}

void Looking::backToLive() {
  if (!playback_) return;
  playback_.reset();
  secondSignals_ = {};
  Q_EMIT signalsReplaced();
  Q_EMIT playbackChanged();
}

const Shown* Looking::whenChosen() const {
  constexpr std::size_t kFarthest = 200;  // frames: slow steps fill several
  if (!playback_) return nullptr;
  const auto& frames = playback_->frames;
  const auto now = static_cast<std::size_t>(playback_->position);
  for (std::size_t back = 1; back <= std::min(now, kFarthest); ++back)
    if (frames[now - back].state != frames[now].state) return &frames[now - back];
  return nullptr;
}

void Looking::showPlayback(double seconds) {
  Playback& p = *playback_;
  if (p.rate > 0) {
    p.position = std::min(p.position + p.rate * seconds, static_cast<double>(p.frames.size()) - 1.0);
    if (p.atEnd()) p.rate = 0;  // the playback stops at the fall
  }
  shown_ = p.frames[static_cast<std::size_t>(p.position)];
}

}  // namespace surefoot
