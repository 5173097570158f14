// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that set conditions against each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/basics/typed_json.h"
#include "core/recipes/judge.h"

namespace surefoot {

using Json = nlohmann::json;
using Pair = std::pair<std::size_t, std::size_t>;

Verdict Judge::ofPairs(const Group& group, const std::vector<Pair>& below, std::size_t claims) {
  std::vector<double> reversed(below.size());
  const auto drawnHold = drawn(group, [&](const std::vector<double>& m) {
    bool holds = true;
    for (std::size_t i = 0; i < below.size(); ++i) {
      const auto [first, second] = below[i];
      holds = holds && m[first] < m[second];
      if (m[second] < m[first]) ++reversed[i];
    }
    return holds ? 1.0 : 0.0;
  });
  if (drawnHold.empty()) return tooFew();
  const double held = surefoot::meanOf(drawnHold);
  j_.ours = std::min(held, j_.ours.value_or(1));
  if (held >= 0.95) return Verdict::Agrees;
  const double most = *std::max_element(reversed.begin(), reversed.end()) / static_cast<double>(drawnHold.size());
  return most >= 1 - 0.05 / static_cast<double>(claims) ? Verdict::Differs : Verdict::Undecided;
}

Verdict Judge::order() {
  std::vector<Pair> below;
  for (std::size_t i = 0; i + 1 < conditions_.size(); ++i) below.push_back({i, i + 1});
  const Verdict verdict = ofPairs(conditions_, below, below.size());
  noteMeans();
  return verdict;
}

Verdict Judge::lowest() {
  std::vector<Pair> below;
  for (std::size_t i = 1; i < conditions_.size(); ++i) below.push_back({0, i});
  const Verdict verdict = ofPairs(conditions_, below, below.size());
  noteMeans();
  return verdict;
}

// The second of a pair may be looked at by another measure: `other`.
Verdict Judge::pairs() {
  const std::string measure = measure_, other = text("other", measure.c_str());
  const Json& list = partOf(arguments_, "pairs");
  std::vector<Verdict> verdicts;
  for (const auto& pair : list) {
    const bool two = pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string();
    const Group first = two ? fitting(pair[0]) : Group{}, second = two ? fitting(pair[1]) : Group{};
    if (first.size() != 1 || second.size() != 1) {
      complain("pairs", fmt::format("{} are not two conditions", jsonText(pair)));
      return Verdict::Undecided;
    }
    const auto meanBy = [&](const Evidence& e, const std::string& by) { return measure_ = by, mean(e); };
    const double a = meanBy(*first[0], measure), b = meanBy(*second[0], other);
    const Verdict verdict = other == measure ? ofPairs({first[0], second[0]}, {{0, 1}}, list.size())
                                             : belowByOther(*first[0], measure, *second[0], other, list.size());
    if (verdict != Verdict::Agrees)
      note(fmt::format("{} {:.4g}, {} {:.4g}", first[0]->name(), a, second[0]->name(), b));
    verdicts.push_back(verdict);
  }
  measure_ = measure;
  if (verdicts.empty()) complain("pairs", "a list of pairs of conditions is expected");
  return all(verdicts);
}

Verdict Judge::belowByOther(const Evidence& a, const std::string& measure, const Evidence& b, const std::string& other,
                            std::size_t claims) {
  measure_ = measure;
  const MeanEstimate first = estimate(a);
  measure_ = other;
  const MeanEstimate second = estimate(b);
  std::size_t reversed = 0;
  const auto holds = drawMeans(
      {first, second}, {0, sameUnits(a, b) ? 0u : 1u},
      [&](const std::vector<double>& m) {
        if (m[1] < m[0]) ++reversed;
        return m[0] < m[1] ? 1.0 : 0.0;
      },
      random_);
  if (holds.empty()) return tooFew();
  const double held = surefoot::meanOf(holds), most = static_cast<double>(reversed) / static_cast<double>(holds.size());
  j_.ours = std::min(held, j_.ours.value_or(1));
  return held >= 0.95                                     ? Verdict::Agrees
         : most >= 1 - 0.05 / static_cast<double>(claims) ? Verdict::Differs
                                                          : Verdict::Undecided;
}

Verdict Judge::notWorse() {
  const Evidence& first = *conditions_[0];
  const double level = kSignificant / static_cast<double>(std::max<std::size_t>(1, conditions_.size() - 1));
  bool better = false, open = false;
  for (const Evidence* e : conditions_) {
    if (e == &first) continue;
    const double pValue = p(first, *e);
    open =
        open || std::isnan(pValue) || (pValue >= level && mayExceed(judged(change(first, *e), first, *e), true, false));
    if (!(pValue < level) || mean(*e) >= mean(first)) continue;
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
  if (conditions_.empty() || conditions_.size() % 2 != 0) complain("conditions", "pairs are expected");
  if (!problem_.empty()) return Verdict::Undecided;
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < conditions_.size(); i += 2) {
    const Evidence &first = *conditions_[i], &second = *conditions_[i + 1];
    const Interval ratio = ratioOf(estimate(second), estimate(first), sameUnits(first, second));
    verdicts.push_back(ofRange(ratio, conditions_.size() > 2 ? first.name() : ""));
    if (i == 0) report(ratio);
    if (conditions_.size() > 2)
      note(fmt::format("{} {:.2f} ({:.2f} … {:.2f})", first.name(), ratio.value, ratio.low, ratio.high));
  }
  return all(verdicts);
}

// Undecided where the interval is wider than the range, or the number lies beside it and the interval reaches it.
Verdict Judge::ofRange(const Interval& i, const std::string& condition) {
  const double low = number("low"), high = number("high");
  if (!i.known()) return tooFew(condition);
  if (!overlaps(i, low, high)) return Verdict::Differs;
  const bool inside = i.value >= low && i.value <= high;
  return inside && i.high - i.low <= high - low ? Verdict::Agrees : tooFew(condition);
}

// The condition is chosen by one half of the lives and reported from the other: the best of many is best by luck, too.
Verdict Judge::extreme() {
  std::optional<Interval> most;
  const Evidence *chosen = nullptr, *against = nullptr;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Interval i = change(halfOf(reference, 0), halfOf(*e, 0));
    if (most && !(i.value < most->value)) continue;
    most = i, chosen = e, against = &reference;
  }
  if (!most) complain("conditions", "none has a reference");
  if (!problem_.empty()) return Verdict::Undecided;
  const Interval ours = change(halfOf(*against, 1), halfOf(*chosen, 1));
  report(ours);
  note(fmt::format("{}, chosen by half of the lives and reported from the others", chosen->name()));
  return ofRange(ours);
}

// By how much the means differ: the largest minus the smallest, or with `relative` over it.
Verdict Judge::spread() {
  const Group others = find("others");
  if (others.empty()) complain("others", "no condition fits");
  if (!problem_.empty()) return Verdict::Undecided;
  Group both = conditions_;
  both.insert(both.end(), others.begin(), others.end());
  const bool relative = flag("relative");
  const auto range = [relative](auto begin, auto end) {
    const double least = *std::min_element(begin, end), most = *std::max_element(begin, end);
    return relative ? most / least : most - least;
  };
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
