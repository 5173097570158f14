// SPDX-License-Identifier: GPL-3.0-or-later
// The strides of a walker, from what was written down of it. A stride is two steps: from one touch-down of the left
// foot to the next, with a touch-down of the right foot between (so a foot that bounces touches down once).
//
// A foot is every contact (group "contacts") whose key has the word left or l, or right or r: left_heel and left_toe,
// shin_r. Its length is that of the measure distance; its energy that of the measure energy, or the positive power of
// all motors.
#pragma once

#include <vector>

#include "core/signals/signal_table.h"

namespace surefoot {

struct Stride {
  std::size_t from = 0, to = 0;  ///< rows: of its first touch-down, and of the next stride's
  double begins = 0.0;           ///< [s]
  double duration = 0.0;         ///< [s]
  double length = 0.0;           ///< [m]; NaN: the distance is not known
  double energy = 0.0;           ///< [J]; NaN: it is not known
  double bothDown = 0.0;         ///< share of its rows with both feet on the floor

  double speed() const { return length / duration; }
  double perMetre() const { return energy / length; }
};

/// Whose foot a contact is.
enum class Foot { None, Left, Right };
Foot footOf(const Signal& signal);
/// The rows in which a foot is on the floor, 0 or 1 each; empty: it has no contact.
std::vector<char> footDown(const SignalTable& table, Foot foot);

/// Empty: it does not walk, or has no feet. Strides do not reach over the end of an episode, or over
/// rows that are missing.
std::vector<Stride> stridesOf(const SignalTable& table);

/// A mean, and the standard deviation (of n − 1).
struct Spread {
  double mean = 0.0, deviation = 0.0;  ///< NaN: there are too few
};
Spread spreadOf(const std::vector<double>& values);

}  // namespace surefoot
