// SPDX-License-Identifier: GPL-3.0-or-later
// Something that was seen before, to be looked at again: a fall, or the last minutes of the window.
#pragma once

#include <QString>
#include <deque>
#include <memory>
#include <vector>

#include "core/action_value.h"
#include "core/life/fall.h"
#include "core/registry.h"

namespace surefoot {

/// What the panels show: the learner's world, or in turbo the viewer's, or a playback.
struct Shown {
  std::vector<double> state, pose, q;
  std::vector<double> qPositive, qNegative;  ///< empty where the agent keeps one estimate
  Action action = kNoAction;
  bool flash = false;  ///< it fell within the last 200 ms
};

struct Playback {
  std::vector<Shown> frames;
  double position = 0.0;  ///< of the frame that is shown
  double rate = 0.0;      ///< frames a second; 0: it stands
  double usualRate = 60;  ///< … while it plays
  QString title;
  std::shared_ptr<const ActionValueFunction> values;  ///< as they were then; nullptr: as they are now

  bool atEnd() const { return position >= static_cast<double>(frames.size()) - 1.0; }
};

/// The last seconds before a fall, at half speed. Empty where the episode cannot be repeated.
Playback playbackOf(const Fall& fall, const Registry& registry, const std::string& environment,
                    std::shared_ptr<const ActionValueFunction> values);

/// What the window has shown, as far back as memory for it goes.
class Recording {
 public:
  static constexpr std::size_t kMostFrames = 5 * 60 * 60;  ///< five minutes at 60 a second
  static constexpr std::size_t kMostBytes = 256u << 20;

  void add(const Shown& frame);
  void clear() { frames_.clear(); }
  std::size_t size() const { return frames_.size(); }
  Playback playback() const;

 private:
  std::deque<Shown> frames_;
};

}  // namespace surefoot
