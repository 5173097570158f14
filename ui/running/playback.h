// SPDX-License-Identifier: GPL-3.0-or-later
// Something that was seen before, to be looked at again: a fall, or the last minutes of the window.
#pragma once

#include <QString>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "core/action_value.h"
#include "core/experiment/configuration.h"
#include "core/life/fall.h"
#include "core/signals/footage.h"
#include "core/signals/rollout.h"

namespace surefoot {

/// The state that the panels show: from the learner's world, in turbo from the viewer's, or from a playback.
struct Shown {
  std::vector<double> state, pose, q;
  std::vector<double> risk;                  ///< ρ; empty where it is not learned
  std::vector<double> qPositive, qNegative;  ///< empty where the agent keeps one estimate
  Action action = kNoAction;
  std::optional<bool> explores{};  ///< `action` was not the best by what the robot knew then; only in a replayed fall
  bool flash = false;              ///< it fell within the last 200 ms
  std::int64_t row = -1;           ///< the row of this moment in what was written down, from the first on; −1: none
};

struct Playback {
  std::vector<Shown> frames;
  double position = 0.0;  ///< index of the frame that is shown
  double begin = 0.0;     ///< where it plays from
  double rate = 0.0;      ///< frames per second; 0: stopped
  double usualRate = 60;  ///< frames per second while it plays
  double realRate = 60;   ///< frames per second of the world's own time, or of the window's where it is live
  QString title;
  std::shared_ptr<const ActionValueFunction> values;  ///< the values at that time; nullptr: the present ones are shown
  SignalTable signals{};                              ///< the signals of its frames
  std::int64_t firstRow = 0;                          ///< frames' rows count from here
  /// How it began, with its pushes, and the environment's parameters: another Q-function can be lived from there.
  /// nullptr: that is not known.
  std::shared_ptr<const Fall> start{};

  bool atEnd() const { return position >= static_cast<double>(frames.size()) - 1.0; }
};

/// The episode of a fall, at half speed, playing its last seconds. Empty if the episode cannot be repeated.
/// `configuration`: of the life that fell.
Playback playbackOf(const Fall& fall, const Registry& registry, const Configuration& configuration,
                    std::shared_ptr<const ActionValueFunction> values);

/// What the greedy policy does with these values in `seconds` from a start that the environment draws, as `surefoot
/// rollout` has it with the same seed. Empty: the environment takes its time.
Playback rolloutOf(const Registry& registry, const Configuration& configuration,
                   std::shared_ptr<const ActionValueFunction> values, double seconds, std::uint64_t seed);

/// The same from where a playback began, with its pushes, as long as that is; by other values. No rows: this cannot be.
SignalTable besideOf(const Playback& playback, const Registry& registry, const Configuration& configuration,
                     const ActionValueFunction& values);

/// What a film shows of it. A fall at its end is seen for a moment longer.
Footage footageOf(const Playback& playback);

/// The last frames that the window has shown, up to kMostFrames and kMostBytes.
class Recording {
 public:
  static constexpr std::size_t kMostFrames = 5 * 60 * 60;  ///< five minutes at 60 per second
  static constexpr std::size_t kMostBytes = 256u << 20;

  void add(const Shown& frame);
  void clear() { frames_.clear(); }
  std::size_t size() const { return frames_.size(); }
  Playback playback() const;
  /// What a film shows of them; their rows count from `firstRow` on.
  Footage footage(std::int64_t firstRow) const;

 private:
  std::deque<Shown> frames_;
};

}  // namespace surefoot
