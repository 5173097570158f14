// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/laboratory/statistics.h"

namespace surefoot {

namespace {

std::size_t pick(std::size_t n, Random& random) {
  return static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
}

/// The mean of values drawn with replacement from each of the groups drawn.
double meanOfDraw(const Groups& groups, const std::vector<std::size_t>& drawn, Random& random) {
  double sum = 0, n = 0;
  for (const std::size_t g : drawn) {
    const auto& group = groups[g];
    for (std::size_t k = 0; k < group.size(); ++k) sum += group[pick(group.size(), random)];
    n += static_cast<double>(group.size());
  }
  return sum / n;
}

}  // namespace

std::vector<double> resample(const std::vector<Groups>& conditions, bool shared,
                             const std::function<double(const std::vector<double>&)>& f, Random& random, int count) {
  std::vector<double> values, means(conditions.size());
  std::vector<std::size_t> drawn;
  for (const Groups& groups : conditions) shared = shared && groups.size() == conditions[0].size();
  for (int i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < conditions.size(); ++c) {
      if (c == 0 || !shared) {
        drawn.assign(conditions[c].size(), 0);
        if (drawn.size() > 1)
          for (std::size_t& g : drawn) g = pick(drawn.size(), random);
      }
      means[c] = meanOfDraw(conditions[c], drawn, random);
    }
    values.push_back(f(means));
  }
  return values;
}

Interval bootstrap(const std::vector<Groups>& conditions, bool shared,
                   const std::function<double(const std::vector<double>&)>& f, Random& random, int count) {
  std::vector<double> means;
  for (const Groups& groups : conditions) {
    std::vector<double> all;
    for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
    means.push_back(meanOf(all));
  }
  std::vector<double> values = resample(conditions, shared, f, random, count);
  std::sort(values.begin(), values.end());
  return {f(means), quantileOfSorted(values, 0.025), quantileOfSorted(values, 0.975)};
}

}  // namespace surefoot
