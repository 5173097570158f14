// SPDX-License-Identifier: GPL-3.0-or-later
// The part of Session for those who look: at states on a map, at falls, at the last minutes. None of it touches the
// life.
#include <algorithm>
#include <iterator>
#include <utility>

#include "ui/controls/preferences.h"
#include "ui/session/session.h"

namespace surefoot {

void Session::takeFalls() {
  constexpr std::size_t kMostValues = 20;
  std::vector<Fall> fresh = std::exchange(fallsToCome_, {});
  for (Fall& fall : learner_->takeFalls()) fresh.push_back(std::move(fall));
  std::erase_if(fresh, [this](const Fall& f) { return f.life != lifeSent_; });
  // The learner is ahead of what the window shows; a fall is listed when the counter has come to it.
  const auto ahead =
      std::find_if(fresh.begin(), fresh.end(), [this](const Fall& f) { return f.number > numbers_.falls; });
  fallsToCome_.assign(std::move_iterator(ahead), std::move_iterator(fresh.end()));
  fresh.erase(ahead, fresh.end());
  if (fresh.empty()) return;
  // The values as they were, as nearly as the window has them. In turbo hundreds of falls come in a second.
  constexpr int kEvery = 500;  // [ms]
  if (values() && copyable() && (!sinceValuesThen_.isValid() || sinceValuesThen_.elapsed() >= kEvery)) {
    sinceValuesThen_.start();
    valuesThen_.emplace_back(fresh.back().number, values()->values->clone());
  }
  if (valuesThen_.size() > kMostValues) valuesThen_.pop_front();
  for (Fall& fall : fresh) falls_.push_back(std::move(fall));
  thinOut(falls_);
  Q_EMIT fallsArrived();
}

void Session::replayFall(std::size_t index) {
  if (index >= falls_.size()) return;
  const Fall& fall = falls_[index];
  std::shared_ptr<const ActionValueFunction> then;
  for (const auto& [number, values] : valuesThen_)
    if (number >= fall.number && !then) then = values;
  if (!then && values() && copyable()) then = values()->values->clone();
  const bool kept = then != nullptr;
  if (!kept && values()) then = {std::shared_ptr<void>(), values()->values.get()};  // for the frames only
  Playback playback = playbackOf(fall, registry_, configuration_.names.environment, std::move(then));
  if (playback.frames.empty()) return;
  if (!kept) playback.values.reset();
  if (reducedMotion()) {  // it stands at the fall, to be stepped through by hand
    playback.rate = 0;
    playback.position = static_cast<double>(playback.frames.size()) - 1;
  }
  playback_ = std::move(playback);
  Q_EMIT playbackChanged();
}

bool Session::copyable() const {
  constexpr std::size_t kMost = 16u << 20;  // [bytes]: more takes the window's thread too long, and twenty too much
  return values()->values->bytes() <= kMost;
}

void Session::lookBack(int frames) {
  if (!playback_) {
    if (recording_.size() < 2 || frames > 0) return;
    playback_ = recording_.playback();
  }
  playback_->rate = 0;
  seek(playback_->position + frames);
}

void Session::seek(double position) {
  if (!playback_) return;
  const double last = static_cast<double>(playback_->frames.size()) - 1.0;
  if (position > last + 0.5 && playback_->rate == 0) return backToLive();
  playback_->position = std::clamp(position, 0.0, last);
  Q_EMIT playbackChanged();
}

void Session::play(bool on) {
  if (!playback_) return;
  if (on && playback_->atEnd()) playback_->position = 0;
  playback_->rate = on ? playback_->usualRate : 0;
  Q_EMIT playbackChanged();
}

void Session::backToLive() {
  if (!playback_) return;
  playback_.reset();
  Q_EMIT playbackChanged();
}

const ActionValueFunction* Session::valuesShown() const {
  if (playback_ && playback_->values) return playback_->values.get();
  return values() ? values()->values.get() : nullptr;
}

void Session::showPlayback(double seconds) {
  Playback& p = *playback_;
  if (p.rate > 0) {
    p.position = std::min(p.position + p.rate * seconds, static_cast<double>(p.frames.size()) - 1.0);
    if (p.atEnd()) p.rate = 0;  // it stands at the fall, to be looked at
  }
  shown_ = p.frames[static_cast<std::size_t>(p.position)];
}

void Session::examine(const std::optional<std::vector<double>>& state) {
  const std::vector<double> next = state.value_or(std::vector<double>());
  if (next == hovered_) return;
  hovered_ = next;
  Q_EMIT examinedChanged();
}

void Session::pin(const std::optional<std::vector<double>>& state) {
  pinned_ = state.value_or(std::vector<double>());
  Q_EMIT examinedChanged();
}

}  // namespace surefoot
