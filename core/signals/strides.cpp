// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signals/strides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace surefoot {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool hasWord(std::string_view key, std::string_view word) {
  for (std::size_t at = key.find(word); at != std::string_view::npos; at = key.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || key[at - 1] == '_') && (end == key.size() || key[end] == '_')) return true;
  }
  return false;
}

/// The motors whose power is told, without the sum of all.
std::vector<std::size_t> motorsIn(const std::vector<Signal>& signals) {
  std::vector<std::size_t> motors;
  for (std::size_t i = 0; i < signals.size(); ++i)
    if (signals[i].group == "motors" && signals[i].unit == "W") motors.push_back(i);
  if (motors.size() > 1) std::erase_if(motors, [&](std::size_t at) { return signals[at].key.starts_with("power"); });
  return motors;
}

/// Energy taken up to each row [J]; empty: it is not known.
std::vector<double> energyTaken(const SignalTable& table) {
  const auto& signals = table.signals();
  for (std::size_t i = 0; i < signals.size(); ++i)
    if (signals[i].group == "measures" && signals[i].key.starts_with("energy")) return table.columns()[i];
  const std::vector<std::size_t> motors = motorsIn(signals);
  if (motors.empty()) return {};
  const std::vector<double>& time = table.columns()[0];
  std::vector<double> taken(table.rows(), 0.0);
  for (std::size_t row = 1; row < taken.size(); ++row) {
    taken[row] = taken[row - 1];
    for (const std::size_t motor : motors)
      taken[row] += std::max(0.0, table.columns()[motor][row]) * (time[row] - time[row - 1]);
  }
  return taken;
}

const std::vector<double>* distanceOf(const SignalTable& table) {
  for (const char* key : {"distance", "distance_measures", "hip_position"})
    if (const auto* column = table.column(key)) return column;
  return nullptr;
}

}  // namespace

Foot footOf(const Signal& signal) {
  if (signal.group != "contacts" || signal.kind != Signal::Kind::OnOff) return Foot::None;
  if (hasWord(signal.key, "left") || hasWord(signal.key, "l")) return Foot::Left;
  if (hasWord(signal.key, "right") || hasWord(signal.key, "r")) return Foot::Right;
  return Foot::None;
}

std::vector<char> footDown(const SignalTable& table, Foot foot) {
  std::vector<char> down;
  for (std::size_t i = 0; i < table.signals().size(); ++i) {
    if (footOf(table.signals()[i]) != foot) continue;
    down.resize(table.rows());
    for (std::size_t row = 0; row < down.size(); ++row) down[row] |= table.columns()[i][row] == 1.0;
  }
  return down;
}

std::vector<Stride> stridesOf(const SignalTable& table) {
  const std::vector<char> left = footDown(table, Foot::Left), right = footDown(table, Foot::Right);
  if (left.empty() || right.empty()) return {};
  const std::vector<double>&time = table.columns()[0], &episode = table.columns()[1];
  const std::vector<double> energy = energyTaken(table);
  const std::vector<double>* distance = distanceOf(table);
  std::vector<Stride> strides;
  std::optional<std::size_t> began;
  bool other = false;  // the right foot has touched down since
  for (std::size_t row = 1; row < left.size(); ++row) {
    if (episode[row] != episode[row - 1] || comesAfterAGap(table, row)) {
      began.reset();
      continue;
    }
    other |= right[row] && !right[row - 1];
    if (!left[row] || left[row - 1]) continue;
    if (began && !other) continue;
    if (began) {
      std::size_t both = 0;
      for (std::size_t r = *began; r < row; ++r) both += left[r] && right[r];
      strides.push_back({.from = *began,
                         .to = row,
                         .begins = time[*began],
                         .duration = time[row] - time[*began],
                         .length = distance ? (*distance)[row] - (*distance)[*began] : kUnknown,
                         .energy = energy.empty() ? kUnknown : energy[row] - energy[*began],
                         .bothDown = static_cast<double>(both) / static_cast<double>(row - *began)});
    }
    began = row;
    other = false;
  }
  return strides;
}

Spread spreadOf(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0.0, squares = 0.0;
  for (const double v : values) sum += v;
  const double mean = n > 0 ? sum / n : kUnknown;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, n > 1 ? std::sqrt(squares / (n - 1)) : kUnknown};
}

}  // namespace surefoot
