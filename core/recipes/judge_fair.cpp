// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that make a comparison fair: at an equal share of exploring, and with the choice of the best among
// many accounted for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/basics/typed_json.h"
#include "core/recipes/judge.h"
#include "core/statistics/statistics_text.h"

namespace surefoot {

using Json = nlohmann::json;

// Falls of `others` at the share that a condition explores, on the line between the two next to it.
Verdict Judge::equalExploring() {
  const auto exploring = [](const Evidence& e) { return meanOf(e, "exploring").value; };
  Group others = find("others");
  std::sort(others.begin(), others.end(),
            [&](const Evidence* a, const Evidence* b) { return exploring(*a) < exploring(*b); });
  if (others.size() < 2) complain("others", "two or more conditions are expected");
  if (!problem_.empty()) return Verdict::Undecided;
  const double sign = number("sign", -1);
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const double share = exploring(*e);
    const auto above =
        std::find_if(others.begin() + 1, others.end() - 1, [&](const Evidence* o) { return exploring(*o) >= share; });
    const Evidence &low = **(above - 1), &high = **above;
    const double at = (share - exploring(low)) / (exploring(high) - exploring(low));
    if (!(at >= 0 && at <= 1)) {
      note(fmt::format("{} explores in {:.1f} % of its steps, which none of the others come near", e->name(),
                       100 * share));
      verdicts.push_back(Verdict::Undecided);
      continue;
    }
    const auto changeIn = [&](const std::vector<double>& m) {
      const double there = (1 - at) * m[1] + at * m[2];
      return 100 * (m[0] - there) / std::abs(there);
    };
    auto changes = drawn({e, &low, &high}, changeIn);
    if (changes.empty()) {
      verdicts.push_back(tooFew(e->name()));
      continue;
    }
    std::sort(changes.begin(), changes.end());
    const auto quantile = [&](double q) { return quantileOfSorted(changes, q); };
    const Interval i{changeIn({mean(*e), mean(low), mean(high)}), quantile(0.025), quantile(0.975)};
    const double nearer = quantile(sign < 0 ? 1 - kSignificant / 2 : kSignificant / 2);
    const double farther = quantile(sign < 0 ? kSignificant / 2 : 1 - kSignificant / 2);
    note(fmt::format("{}, {:.1f} %: {} % ({} … {})", e->name(), 100 * share, signedText(i.value, 0),
                     signedText(i.low, 0), signedText(i.high, 0)));
    if (!j_.ours || (i.value - *j_.ours) * sign < 0) report(i);
    const bool none = farther * sign <= 0 || !mayExceed(i, sign<0, sign> 0);
    verdicts.push_back(nearer * sign > 0 ? Verdict::Agrees : none ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

// Chosen by one half of the units: of each parameter the value that is best while the others stay as in the first
// condition, and the best of all conditions. Measured with the other half: do the best values together do as well?
Verdict Judge::addsUp() {
  std::vector<std::string> keys;
  for (const Json& key : partOf(arguments_, "alongs"))
    if (key.is_string()) keys.push_back(key);
  if (keys.size() < 2 || conditions_.size() < 2) complain("alongs", "two parameters or more, and conditions of them");
  if (!problem_.empty()) return Verdict::Undecided;
  const auto values = [&](const Evidence& e) {
    std::vector<double> all;
    for (const std::string& key : keys) all.push_back(parameterOf(e, key));
    return all;
  };
  const auto chosenBy = [&](const Evidence& e) { return estimateOf(halfOf(e, 0), measure_).value; };
  const std::vector<double> first = values(*conditions_[0]);
  std::vector<double> together = first, least(keys.size(), chosenBy(*conditions_[0]));
  const Evidence* best = conditions_[0];
  double bestValue = least[0];
  for (const Evidence* e : conditions_) {
    const std::vector<double> here = values(*e);
    const double value = chosenBy(*e);
    if (value < bestValue) bestValue = value, best = e;
    for (std::size_t k = 0; k < keys.size(); ++k) {
      std::vector<double> others = here;
      others[k] = first[k];
      if (others == first && value < least[k]) least[k] = value, together[k] = here[k];
    }
  }
  const auto found =
      std::find_if(conditions_.begin(), conditions_.end(), [&](const Evidence* e) { return values(*e) == together; });
  if (!problem_.empty()) return Verdict::Undecided;
  if (found == conditions_.end()) {
    complain("conditions", "the best values together are none of them");
    return Verdict::Undecided;
  }
  note(fmt::format("the best values together: {}; the best of all: {}", (*found)->name(), best->name()));
  if (*found == best) return Verdict::Differs;
  const Evidence combined = halfOf(**found, 1), optimum = halfOf(*best, 1);
  const Interval i = change(optimum, combined);
  report(i);
  const double pValue = p(optimum, combined);
  if (std::isnan(pValue)) return tooFew();
  j_.p = pValue;
  if (pValue < kSignificant && i.low > 0) return Verdict::Agrees;
  return mayExceed(i, false, true) ? tooFew() : Verdict::Differs;
}

}  // namespace surefoot
