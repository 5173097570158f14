// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims about the best choice among several, and about the course of learning.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/basics/typed_json.h"
#include "core/recipes/judge.h"
#include "core/statistics/statistics_text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

using Json = nlohmann::json;

/// The position of the lowest of `count` means from `first` on.
std::size_t lowestOf(const std::vector<double>& means, std::size_t first, std::size_t count) {
  const auto begin = means.begin() + static_cast<std::ptrdiff_t>(first);
  return static_cast<std::size_t>(std::min_element(begin, begin + static_cast<std::ptrdiff_t>(count)) - begin);
}

/// Bands with a mean width above half of the curve's largest value overlap in any case and show nothing.
bool narrow(const Curve& curve) {
  double largest = 0, width = 0;
  for (const Interval& i : curve.y) {
    largest = std::max(largest, std::abs(i.value));
    width += i.high - i.low;
  }
  return width <= largest / 2 * static_cast<double>(curve.y.size());  // not if it is NaN
}

}  // namespace

double Judge::parameterOf(const Evidence& e, const std::string& key) {
  const double value = numberIn(partOf(e.configuration, "parameters"), key);
  if (std::isfinite(value)) return value;
  complain("along", fmt::format("\"{}\" is no number of {}", key, e.name()));
  return std::nan("");
}

// Which Q-function shall go on the robot? Rows of lives are independent of each other.
Verdict Judge::chosen() {
  const Group by = find("by");
  const std::string other = text("other", ""), choose = text("choose", "lowest");
  const double of = number("of", 5.0), sign = number("sign", -1.0);
  if (choose != "lowest" && choose != "highest") complain("choose", "it takes lowest or highest");
  if (!(of >= 2)) complain("of", "it takes 2 or more");
  if (by.size() != 1 || conditions_.empty()) complain("by", "one condition is expected, and one to look at");
  if (!problem_.empty()) return Verdict::Undecided;
  const std::vector<double> looks = valuesOf(*by[0], other), falls = values(*conditions_[0]);
  if (looks.empty()) complain("other", fmt::format("it takes {}", joinWords(measureNames(by[0]->taskMeasures), "or")));
  const auto row = static_cast<std::size_t>(of);
  std::vector<double> picked, whole;
  for (std::size_t from = 0; from + row <= std::min(looks.size(), falls.size()); from += row) {
    const auto begin = looks.begin() + static_cast<std::ptrdiff_t>(from),
               end = begin + static_cast<std::ptrdiff_t>(row);
    const auto best = choose == "lowest" ? std::min_element(begin, end) : std::max_element(begin, end);
    picked.push_back(falls[static_cast<std::size_t>(best - looks.begin())]);
    whole.push_back(surefoot::meanOf(Sample(falls).subspan(from, row)));
  }
  const auto test = pairedTest(picked, whole);
  std::vector<double> changes;
  const double mean = surefoot::meanOf(whole);
  for (std::size_t i = 0; i < picked.size(); ++i) changes.push_back(100.0 * (picked[i] - whole[i]) / mean);
  const auto change = meanInterval(changes);
  if (!test || !change || !(mean > 0)) return tooFew();
  report(*change);
  j_.p = test->p;
  note(fmt::format("{} rows of {}", picked.size(), row));
  if (test->p < kSignificant) return agreesIf(change->value * sign > 0);
  return mayExceed(*change, true, true) ? Verdict::Undecided : Verdict::Differs;
}

// In every draw of the means each group has a best value of the parameter; these values are compared.
Verdict Judge::best() {
  const std::string along = text("along", ""), relation = text("relation", "same");
  std::vector<std::vector<double>> values;  // values of the parameter: [group][condition]
  std::vector<std::size_t> firsts;
  Group everything;
  for (const Json& list : partOf(arguments_, "groups")) {
    firsts.push_back(everything.size());
    auto& own = values.emplace_back();
    for (const Json& pattern : list)
      for (const Evidence* e : pattern.is_string() ? fitting(pattern) : Group{})
        everything.push_back(e), own.push_back(parameterOf(*e, along));
    if (own.size() < 2) complain("groups", fmt::format("{} names fewer than two conditions", jsonText(list)));
  }
  const bool alone = values.size() == 1 && arguments_.contains("thesis");
  if (values.size() < 2 && !alone) complain("groups", "two or more are expected, or one and the thesis's value");
  if (relation != "same" && relation != "lower" && relation != "not-lower")
    complain("relation", "it takes same, lower or not-lower");
  if (!problem_.empty()) return Verdict::Undecided;

  const auto bestOf = [&](const std::vector<double>& means, std::size_t group) {
    return values[group][lowestOf(means, firsts[group], values[group].size())];
  };
  std::vector<double> ours;
  for (const Evidence* e : everything) ours.push_back(mean(*e));
  std::vector<Interval> intervals;
  bool open = false;  // more than half of the values may be the best of a group
  for (std::size_t g = 0; g < values.size(); ++g) {
    std::vector<double> bests = drawn(everything, [&](const auto& means) { return bestOf(means, g); });
    if (bests.empty()) return tooFew();
    std::sort(bests.begin(), bests.end());
    intervals.push_back({bestOf(ours, g), quantileOfSorted(bests, 0.025), quantileOfSorted(bests, 0.975)});
    const auto held =
        std::count_if(values[g].begin(), values[g].end(), [&](double v) { return overlaps(intervals[g], v, v); });
    open = open || 2 * held > static_cast<std::ptrdiff_t>(values[g].size());
    note(fmt::format("best {:g} ({:g} … {:g})", intervals[g].value, intervals[g].low, intervals[g].high));
  }
  report(intervals[0]);
  if (alone) {
    const double thesis = number("thesis");
    if (!overlaps(intervals[0], thesis, thesis)) return Verdict::Differs;
    return open ? tooFew() : Verdict::Agrees;
  }
  if (relation == "same") {
    const bool same = std::all_of(intervals.begin(), intervals.end(),
                                  [&](const Interval& i) { return overlaps(i, intervals[0].low, intervals[0].high); });
    return same && open ? tooFew() : agreesIf(same);
  }
  return ofShare(share(everything, [&](const auto& means) {
    for (std::size_t g = 1; g < values.size(); ++g) {
      const double first = bestOf(means, 0), other = bestOf(means, g);
      if (relation == "lower" ? first >= other : first < other) return false;
    }
    return true;
  }));
}

Verdict Judge::compromise() {
  const std::string other = text("other", ""), measure = measure_;
  const Evidence& first = *conditions_[0];
  if (valuesOf(first, other).empty()) complain("other", "a second measure is expected");
  const double level = kSignificant / static_cast<double>(std::max<std::size_t>(1, conditions_.size() - 1));
  enum class Is { Better, Open, NotBetter };
  const auto against = [&](const Evidence& e, const std::string& by) {
    measure_ = by;
    const double pValue = p(first, e);
    if (pValue < level) {
      if (mean(e) >= mean(first)) return Is::NotBetter;
      return leavesZeroIn(first, e) ? Is::Open : Is::Better;
    }
    return std::isnan(pValue) || mayExceed(judged(change(first, e), first, e), true, false) ? Is::Open : Is::NotBetter;
  };
  bool beaten = false, open = false;
  for (const Evidence* e : conditions_) {
    if (e == &first) continue;
    const Is one = against(*e, measure), two = against(*e, other);
    if (one == Is::NotBetter || two == Is::NotBetter) continue;
    const bool both = one == Is::Better && two == Is::Better;
    if (both) note(e->name() + " is better in both");
    beaten = beaten || both;
    open = open || !both;
  }
  for (const std::string& m : {measure, other}) measure_ = m, noteMeans();
  measure_ = measure;
  report(interval(first));
  return open && !beaten ? tooFew() : agreesIf(!beaten);
}

// Cohen's d of each against its reference, with the spread of the lives that are there; or, `relative`, the change.
Verdict Judge::effectOrder() {
  const bool relative = flag("relative");
  if (conditions_.size() % 2 != 0) complain("conditions", "pairs are expected");
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; problem_.empty() && i + 1 < conditions_.size(); i += 2) {
    const Evidence &smaller = *conditions_[i], &larger = *conditions_[i + 1];
    const Group four = {&smaller, referenceOf(smaller), &larger, referenceOf(larger)};
    const auto spread = [&](const Evidence& a, const Evidence& b) {
      const double va = varianceOf(values(a)), vb = varianceOf(values(b));
      return std::sqrt((va + vb) / 2);
    };
    const double s1 = spread(*four[0], *four[1]), s2 = spread(*four[2], *four[3]);
    if (!(s1 > 0) || !(s2 > 0)) {
      verdicts.push_back(tooFew(smaller.name()));
      continue;
    }
    const auto gain = [&](const std::vector<double>& m, std::size_t at, double s) {
      return (m[at + 1] - m[at]) / (relative ? std::abs(m[at + 1]) : s);
    };
    const double held = share(four, [&](const auto& m) { return gain(m, 0, s1) < gain(m, 2, s2); });
    std::vector<double> means;
    for (const Evidence* e : four) means.push_back(mean(*e));
    note(fmt::format("{} {:.2f}, {} {:.2f}", smaller.name(), gain(means, 0, s1), larger.name(), gain(means, 2, s2)));
    if (std::isfinite(held)) j_.ours = std::min(held, j_.ours.value_or(1));
    verdicts.push_back(ofShare(held));
  }
  return all(verdicts);
}

Verdict Judge::bandsOverlap() {
  constexpr std::size_t kPoints = 361;
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Curve a = learningCurve(reference.record, kPoints), b = learningCurve(e->record, kPoints);
    const std::size_t points = std::min(a.y.size(), b.y.size());
    if (points == 0 || !narrow(a) || !narrow(b)) {
      verdicts.push_back(tooFew(e->name()));
      continue;
    }
    std::size_t together = 0;
    for (std::size_t i = 0; i < points; ++i) together += overlaps(a.y[i], b.y[i].low, b.y[i].high);
    const double part = static_cast<double>(together) / static_cast<double>(points);
    j_.ours = std::min(part, j_.ours.value_or(1));
    note(fmt::format("{}: at {:.0f} % of the moments", e->name(), 100 * part));
    verdicts.push_back(agreesIf(part >= 0.95));
  }
  return all(verdicts);
}

// The lowest point of the mean average reward, life by life against the average of the first episodes: found by one
// half of the lives and measured with the other.
Verdict Judge::dips() {
  const auto first = static_cast<std::size_t>(std::max(1.0, number("first", 10)));
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    if (e->averages.size() <= first) {
      complain("first", fmt::format("{} has {} episodes only", e->name(), e->averages.size()));
      return Verdict::Undecided;
    }
    const Evidence finding = halfOf(*e, 0), measuring = halfOf(*e, 1);
    const std::vector<double> found = meanAverageRewards(finding.record);
    const auto begin = found.begin() + static_cast<std::ptrdiff_t>(std::min(first, found.size() - 1));
    const auto lowest = static_cast<std::size_t>(
        std::min_element(begin, found.begin() + static_cast<std::ptrdiff_t>(e->averages.size())) - found.begin());
    std::vector<double> changes;
    for (const auto& episodes : measuring.record.episodes) {
      const auto averages = averageRewards(episodes);
      changes.push_back(averages[lowest] - averages[first - 1]);
    }
    const Interval i = intervalOf(estimateOf(changes, unitsOf(measuring.record)));
    if (!i.known()) {
      report(i);
      verdicts.push_back(tooFew(e->name()));
      continue;
    }
    note(fmt::format("{}: {} ({} … {}) at episode {}", e->name(), signedText(i.value, 0), signedText(i.low, 0),
                     signedText(i.high, 0), lowest + 1));
    if (!j_.high || i.high > *j_.high) report(i);
    verdicts.push_back(i.high < 0 ? Verdict::Agrees : i.low >= 0 ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

}  // namespace surefoot
