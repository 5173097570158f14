// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plans/plan_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/basics/random.h"

namespace surefoot {

namespace {

constexpr int kMostSystems = 1000;
constexpr std::string_view kWord = "system ";

struct Range {
  std::string key;
  double low = 0, high = 0;

  double at(double share) const { return low > 0 ? low * std::pow(high / low, share) : low + (high - low) * share; }
};

Result<Range> rangeOf(const PlanSetting& s) {
  const Error two{fmt::format("{}: a range is expected, [low, high].", s.key)};
  if (s.values.size() != 2) return two;
  Range range{.key = s.key.substr(4)};
  for (std::size_t i = 0; i < 2; ++i) {
    std::optional<double> end;
    if (const Status read = readNumber(s.key, s.values[i], -1e9, 1e9, end); !read) return read.error();
    (i == 0 ? range.low : range.high) = *end;
  }
  if (!(range.low < range.high)) return two;
  return range;
}

/// 0 … n − 1 in random order (Fisher & Yates).
std::vector<int> shuffled(int n, Random& random) {
  std::vector<int> order;
  for (int i = 0; i < n; ++i) order.push_back(i);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  return order;
}

}  // namespace

Result<std::vector<DrawnSystem>> drawSystems(const std::vector<PlanSetting>& settings, const std::string& path) {
  std::vector<DrawnSystem> systems;
  if (settings.empty()) return systems;
  int count = 0;
  std::uint64_t seed = 1;
  std::vector<Range> ranges;
  for (const PlanSetting& s : settings) {
    Status status = Done{};
    if (s.key == "count") {
      status = readCount(s.key, s.values.front(), kMostSystems, count);
    } else if (s.key == "seed") {
      status = readSeed(s.values.front(), seed);
    } else if (s.key.starts_with("set.")) {
      auto range = rangeOf(s);
      if (range)
        ranges.push_back(std::move(*range));
      else
        status = range.error();
    } else {
      status = unknownKey(s.key, {"count", "seed", "set"});
    }
    if (!status) return planError(path, s.line, "systems: " + status.error().message);
  }
  if (count < 2 || ranges.empty())
    return planError(path, settings.front().line,
                     "systems: it takes count, from 2 on, and at least one set.KEY = [low, high].");
  Random random(seed);
  for (int i = 0; i < count; ++i) systems.push_back({fmt::format("{}{}: ", kWord, i + 1), {}});
  for (const Range& range : ranges) {
    const std::vector<int> places = shuffled(count, random);
    for (std::size_t i = 0; i < systems.size(); ++i)
      systems[i].assignments.push_back(
          {range.key, fmt::format("{:.4g}", range.at((places[i] + random.uniform()) / count))});
  }
  return systems;
}

double systemsIn(const std::vector<PlanSetting>& settings) {
  for (const PlanSetting& s : settings)
    if (int count = 0; s.key == "count" && readCount(s.key, s.values.front(), kMostSystems, count)) return count;
  return 1;
}

std::pair<int, std::string> systemOf(const std::string& name) {
  if (!name.starts_with(kWord)) return {0, name};
  int number = 0;
  const char* begin = name.data() + kWord.size();
  const auto [end, failed] = std::from_chars(begin, name.data() + name.size(), number);
  const std::string rest = name.substr(static_cast<std::size_t>(end - name.data()));
  return failed == std::errc() && rest.starts_with(": ") ? std::pair(number, rest.substr(2)) : std::pair(0, name);
}

}  // namespace surefoot
