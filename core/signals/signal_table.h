// SPDX-License-Identifier: GPL-3.0-or-later
// What is written down of an environment in which somebody acts: columns of numbers, one row a step.
//
// A row is the moment before an action: the time, the state, the environment's own signals and measures then, the
// action that was chosen and what the Q-function said of it, and the reward that it brought. A number that a row does
// not have is NaN: what an action brought before that is known, and δ until the next row is there.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/environment.h"

namespace surefoot {

/// Every signal: time and episode, the state, the environment's own, its measures, the action, the learner's, the
/// reward and its terms, events.
std::vector<Signal> signalsOf(const Environment& environment, bool hasRisk);

/// The moment before an action.
struct Moment {
  double time = 0.0;                                   ///< [s], or steps where the task has no clock
  std::int64_t episode = 1;                            ///< from 1
  std::span<const double> state{}, own{}, measures{};  ///< `own`: Environment::readSignals
  std::span<const double> q{}, risk{};                 ///< of every action
  Action action = kNoAction;                           ///< kNoAction: none is chosen, the episode is over
  double probability = 0.0;                            ///< π of the action
  bool explores = false;
};

/// Used by one thread.
class SignalTable {
 public:
  SignalTable() = default;
  SignalTable(const Environment& environment, bool hasRisk);

  /// Adds a row.
  void before(const Moment& moment);
  /// The same; state, own signals and measures are read from the environment.
  void before(const Environment& environment, Moment moment);
  /// What the action of the last row brought.
  void after(const Outcome& outcome);
  /// δ = r + γ Q(s′, a′) − Q(s, a) of the row before the last, which the last one makes known; or of the last, if it
  /// ended the episode.
  void learn(double discount);
  /// Forgets the oldest rows.
  void dropFirst(std::size_t rows);
  /// Forgets the last row.
  void dropLast();
  void clear() { dropFirst(rows()); }

  const std::vector<Signal>& signals() const { return signals_; }
  const std::vector<std::vector<double>>& columns() const { return columns_; }  ///< [signal][row]
  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
  /// nullptr: there is no such signal.
  const std::vector<double>* column(std::string_view key) const;
  /// One row a line, keys in the first; what is not known is empty.
  std::string asCsv() const;
  /// Between two rows [s], or 1 step.
  double stepTime() const { return task_.stepTime.value_or(1.0); }

 private:
  double& last(std::size_t column, std::size_t back = 0) { return *(columns_[column].end() - 1 - back); }

  Task task_{};
  std::vector<Signal> signals_{};
  std::vector<std::vector<double>> columns_{};
  std::vector<double> own_{};
  std::size_t q_ = 0, reward_ = 0, end_ = 0, delta_ = 0;  ///< columns
};

/// Whether rows are missing before this one: more time has passed than a step takes. False for the first row.
bool comesAfterAGap(const SignalTable& table, std::size_t row);

/// The place of a signal by its key; signals.size(): there is none.
std::size_t signalAt(const std::vector<Signal>& signals, std::string_view key);

}  // namespace surefoot
