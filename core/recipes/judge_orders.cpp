// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that set conditions against each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/basics/typed_json.h"
#include "core/recipes/judge.h"

namespace surefoot {

Verdict Judge::order() {
  const double held = share(conditions_, [](const auto& m) { return std::is_sorted(m.begin(), m.end()); });
  if (std::isfinite(held)) j_.ours = held;
  noteMeans();
  return ofShare(held);
}

Verdict Judge::lowest() {
  const double held = share(conditions_, [](const auto& m) { return *std::min_element(m.begin(), m.end()) == m[0]; });
  if (std::isfinite(held)) j_.ours = held;
  noteMeans();
  return ofShare(held);
}

Verdict Judge::pairs() {
  std::vector<Verdict> verdicts;
  for (const auto& pair : partOf(arguments_, "pairs")) {
    const bool two = pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string();
    const Group first = two ? fitting(pair[0]) : Group{}, second = two ? fitting(pair[1]) : Group{};
    if (first.size() != 1 || second.size() != 1) {
      complain("pairs", fmt::format("{} are not two conditions", jsonText(pair)));
      return Verdict::Undecided;
    }
    const double held = share({first[0], second[0]}, [](const auto& m) { return m[0] < m[1]; });
    if (!(held >= 0.95))
      note(fmt::format("{} {:.4g}, {} {:.4g}", first[0]->name(), mean(*first[0]), second[0]->name(), mean(*second[0])));
    if (std::isfinite(held)) j_.ours = std::min(j_.ours.value_or(1), held);
    verdicts.push_back(ofShare(held));
  }
  if (verdicts.empty()) complain("pairs", "a list of pairs of conditions is expected");
  return all(verdicts);
}

Verdict Judge::notWorse() {
  const Evidence& first = *conditions_[0];
  bool better = false, open = false;
  for (const Evidence* e : conditions_) {
    if (e == &first) continue;
    const double pValue = p(first, *e);
    open = open || std::isnan(pValue) ||
           (pValue >= kSignificant && mayExceed(judged(change(first, *e), first, *e), true, false));
    if (!(pValue < kSignificant) || mean(*e) >= mean(first)) continue;
    if (leavesZeroIn(first, *e)) {
      open = true;
      continue;
    }
    better = true;
    note(fmt::format("{} is better (p {:.2g})", e->name(), pValue));
    j_.p = std::min(pValue, j_.p.value_or(1));
  }
  report(interval(first));
  noteMeans();
  if (open && !better) return tooFew();
  return agreesIf(!better);
}

Verdict Judge::ratio() {
  if (conditions_.size() != 2) complain("conditions", "two are expected");
  if (!problem_.empty()) return Verdict::Undecided;
  const Interval i = ratioOf(estimateOf(*conditions_[1], measure_), estimateOf(*conditions_[0], measure_),
                             sameUnits(*conditions_[0], *conditions_[1]));
  report(i);
  return ofRange(i);
}

// Undecided where the interval is wider than the range, or the number lies beside it and the interval reaches it.
Verdict Judge::ofRange(const Interval& i) {
  const double low = number("low"), high = number("high");
  if (!i.known()) return tooFew();
  if (!overlaps(i, low, high)) return Verdict::Differs;
  const bool inside = i.value >= low && i.value <= high;
  return inside && i.high - i.low <= high - low ? Verdict::Agrees : tooFew();
}

Verdict Judge::extreme() {
  std::optional<Interval> most;
  std::string where;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Interval i = change(reference, *e);
    if (most && !(i.value < most->value)) continue;
    most = i, where = e->name();
  }
  if (!most) complain("conditions", "none has a reference");
  if (!problem_.empty()) return Verdict::Undecided;
  report(*most);
  note(where);
  return ofRange(*most);
}

Verdict Judge::spread() {
  const Group others = find("others");
  if (others.empty()) complain("others", "no condition fits");
  if (!problem_.empty()) return Verdict::Undecided;
  Group both = conditions_;
  both.insert(both.end(), others.begin(), others.end());
  const auto range = [](auto begin, auto end) { return *std::max_element(begin, end) - *std::min_element(begin, end); };
  const auto split = static_cast<std::ptrdiff_t>(conditions_.size());
  const double held = share(
      both, [&](const auto& m) { return range(m.begin(), m.begin() + split) < range(m.begin() + split, m.end()); });
  if (std::isfinite(held)) j_.ours = held;
  noteMeans();
  return ofShare(held);
}

void Judge::noteMeans() {
  std::vector<std::string> means;
  for (const Evidence* e : conditions_) means.push_back(fmt::format("{} {:.4g}", e->name(), mean(*e)));
  note(fmt::format("{}", fmt::join(means, ", ")));
}

}  // namespace surefoot
