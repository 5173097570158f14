// SPDX-License-Identifier: GPL-3.0-or-later
// Which signals are shown, in strips one below the other: a strip holds one signal, or several.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/signals/signal_table.h"

namespace surefoot {

/// Keys of the signals of a strip, in the order of their drawing.
using Strip = std::vector<std::string>;

/// How a strip is drawn.
enum class StripLook {
  Lines,    ///< curves
  Steps,    ///< constant until the next row: what an action commands
  Filled,   ///< a curve with its area down to 0: power
  Bars,     ///< a bar from 0 for each row: δ
  Stacked,  ///< bars on top of each other: the terms of the reward
  OnOff,    ///< a row of bars for each signal
};

/// A strip's signals by their places in a table, those that it has.
struct StripSignals {
  std::vector<std::size_t> places;
  StripLook look = StripLook::Lines;
};
StripSignals signalsIn(const Strip& strip, const std::vector<Signal>& signals);

/// A column of `like` in a table of another learner, whose signals may be fewer or more; nullptr: it has none.
const std::vector<double>* columnLike(const SignalTable& of, const SignalTable& like, std::size_t place);
/// The row of a time, at most half a step away; none: nothing was written down then.
std::optional<std::size_t> rowAt(const SignalTable& table, double time);

/// What is shown of an environment at first: what a robot engineer looks at.
std::vector<Strip> usualStrips(const std::vector<Signal>& signals);

/// "torso angle": what stands beside a strip; and behind it, "rad".
QString titleOf(const StripSignals& strip, const std::vector<Signal>& signals);
QString unitOf(const StripSignals& strip, const std::vector<Signal>& signals);
/// The short name of one of several signals of a strip.
QString nameIn(const StripSignals& strip, const Signal& signal);

/// The strips that a person chose last in this environment, or the usual ones; and to keep such a choice (empty: none).
std::vector<Strip> chosenStrips(const std::string& environment, const std::vector<Signal>& signals);
void keepStrips(const std::string& environment, const std::vector<Strip>& strips);
/// A text for the settings: keys with "+" between those of a strip and "," between strips; and back.
QString toSettings(const std::vector<Strip>& strips);
std::vector<Strip> fromSettings(const QString& text);

}  // namespace surefoot
