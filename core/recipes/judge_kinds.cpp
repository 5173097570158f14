// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of claims that look at one condition after the other, each against its reference if there is one.
#include "core/recipes/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "core/parameters.h"
#include "core/statistics/statistics_text.h"
#include "core/text/words.h"

namespace surefoot {

namespace {

/// The upper end of the 95 % interval of a variance component's share (Searle 1971), for groups of about one size n:
/// (F/q − 1)/(F/q − 1 + n) with the 2.5 % quantile q of F.
double mostShare(const VarianceComponent& component, const Groups& groups) {
  double size = 0;
  for (const auto& group : groups) size += static_cast<double>(group.size()) / static_cast<double>(groups.size());
  const boost::math::fisher_f f(component.test.degrees1, component.test.degrees2);
  const double ratio = component.test.statistic / boost::math::quantile(f, 0.025) - 1;
  return std::isfinite(ratio) ? ratio / (ratio + size) : 1;
}

}  // namespace

Verdict Judge::value() {
  const double thesis = number("thesis");
  const double within = number("within", std::abs(thesis) * number("tolerance", 0.1));
  const Interval i = interval(*conditions_[0]);
  report(i);
  if (!i.known()) return tooFew();
  const bool reached = overlaps(i, thesis - within, thesis + within);
  const bool wide = (i.high - i.low) / 2 > 2.5 * within;  // as with ± 25 % for a number that is met within 10 %
  return reached && wide ? tooFew() : agreesIf(reached);
}

/// Two studies of one change, the thesis's and ours: do they agree on its direction, and on its size? The thesis prints
/// no interval, but its p, of n lives a side, says how large its standard error was: |change| over the quantile of t.
Verdict Judge::replication(const Interval& ours, double pValue) {
  const double thesis = number("thesis"), lives = number("thesis_lives", 40), degrees = 2 * lives - 2;
  const boost::math::students_t t(degrees);
  const double error = std::abs(thesis) / boost::math::quantile(boost::math::complement(t, number("thesis_p") / 2));
  constexpr double kNormal = 1.96;
  const double ourError = (ours.high - ours.low) / (2 * kNormal);
  const double z = (ours.value - thesis) / std::hypot(error, ourError);
  const bool sizeAgrees = std::abs(z) <= kNormal, shown = pValue < kSignificant && (ours.low > 0 || ours.high < 0);
  const bool sameDirection = (ours.value < 0) == (thesis < 0);
  note(fmt::format("the thesis's ± {:.0f}, difference of the two studies {} standard errors", kNormal * error,
                   signedText(z, 1)));
  if (shown && !sameDirection) return Verdict::Differs;
  if (!sizeAgrees) {
    if (shown) note("the direction agrees, the size differs");
    return Verdict::Differs;
  }
  if (!shown) note("ours is not significant by itself");
  return shown ? Verdict::Agrees : Verdict::Undecided;
}

Verdict Judge::reduction() {
  const double thesis = number("thesis");
  const bool least = arguments_.contains("at_least");
  const double atLeast = least ? number("at_least") : std::abs(thesis);
  const Evidence& e = *conditions_[0];
  const Evidence& reference = *referenceOf(e);
  const Interval shown = change(reference, e), i = judged(shown, reference, e);
  const double pValue = p(reference, e);
  report(shown);
  if (!i.known() || std::isnan(pValue)) return tooFew();
  j_.p = pValue;
  if (arguments_.contains("thesis_p")) return replication(i, pValue);
  if (pValue >= kSignificant) {
    const bool reached = least ? (thesis < 0 ? -i.low : i.high) >= atLeast : overlaps(i, thesis - 10, thesis + 10);
    return reached && leavesOpen(i, thesis, atLeast) ? tooFew() : Verdict::Differs;
  }
  if (leavesZeroIn(reference, e)) return Verdict::Undecided;
  if (toNothing_) note("it is 0 in every life");
  const bool size = least ? std::abs(i.value) >= atLeast : overlaps(i, thesis - 10, thesis + 10);
  const bool direction = (i.value < 0) == (thesis < 0);
  if (direction && !size) note("direction and significance agree, size differs");
  return agreesIf(direction && size);
}

Verdict Judge::significant() {
  const double sign = number("sign", -1);
  double weakest = std::numeric_limits<double>::infinity();
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const double pValue = p(reference, *e);
    const Interval i = change(reference, *e);
    if (std::isnan(pValue)) {
      report(i);
      verdicts.push_back(tooFew(e->name()));
      continue;
    }
    j_.p = std::max(pValue, j_.p.value_or(0));
    if (!(i.value * sign > weakest)) weakest = i.value * sign, report(i);  // shown is what says least
    if (pValue < kSignificant && leavesZeroIn(reference, *e)) {
      verdicts.push_back(Verdict::Undecided);
      continue;
    }
    const bool holds = pValue < kSignificant && (mean(*e) - mean(reference)) * sign > 0;
    if (!holds) note(fmt::format("not {} (p {:.2g})", e->name(), pValue));
    const bool open = pValue >= kSignificant && leavesOpen(judged(i, reference, *e), sign, 10);
    verdicts.push_back(open ? tooFew(e->name()) : agreesIf(holds));
  }
  return all(verdicts);
}

Verdict Judge::noDifference() {
  const double level = kSignificant / static_cast<double>(std::max<std::size_t>(1, conditions_.size()));
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const double pValue = p(reference, *e);
    const Interval i = change(reference, *e);
    // Shown is what reaches furthest, for that is what could be missed.
    const auto reach = [](const Interval& change) { return std::max(std::abs(change.low), std::abs(change.high)); };
    if (!j_.low || (i.known() && reach(i) > reach({0, *j_.low, *j_.high}))) report(i);
    if (pValue <= j_.p.value_or(1)) j_.p = pValue;
    if (pValue < level && leavesZeroIn(reference, *e)) {
      verdicts.push_back(Verdict::Undecided);
    } else if (pValue < level) {
      note(fmt::format("{} differs{} (p {:.2g})", e->name(),
                       std::isfinite(i.value) ? fmt::format(" by {} %", signedText(i.value, 0)) : "", pValue));
      verdicts.push_back(Verdict::Differs);
    } else {
      verdicts.push_back(mayExceed(judged(i, reference, *e), true, true) ? tooFew(e->name()) : Verdict::Agrees);
    }
  }
  return all(verdicts);
}

Verdict Judge::withinLives() {
  const std::string other = text("other", "");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const auto a = valuesOf(*e, measure_), b = valuesOf(*e, other);
    if (b.empty()) complain("other", fmt::format("it takes {}", joinWords(measureNames(e->taskMeasures), "or")));
    std::vector<double> differences;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) differences.push_back(b[i] - a[i]);
    const Interval i = intervalOf(estimateOf(differences, unitsOf(e->record)));
    if (!i.known()) {
      note(fmt::format("{}: too few lives have both", e->name()));
      verdicts.push_back(Verdict::Undecided);
      continue;
    }
    if (i.low <= 0) note(fmt::format("{}: {:+.3g} ({:+.3g} … {:+.3g})", e->name(), i.value, i.low, i.high));
    if (!j_.low || i.low < *j_.low) report(i);
    verdicts.push_back(i.low > 0 ? Verdict::Agrees : i.high < 0 ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

Verdict Judge::notLonger() {
  measure_ = text("measure", "minutes");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Interval shown = change(reference, *e), i = judged(shown, reference, *e);
    if (!j_.high || i.high > *j_.high) report(shown);
    if (i.low > 0)
      note(fmt::format("{}: {} % ({} … {})", e->name(), signedText(i.value, 0), signedText(i.low, 0),
                       signedText(i.high, 0)));
    if (!i.known())
      verdicts.push_back(tooFew(e->name()));
    else
      verdicts.push_back(i.low > 0 ? Verdict::Differs : i.high >= 15 ? Verdict::Undecided : Verdict::Agrees);
  }
  return all(verdicts);
}

Verdict Judge::below() {
  const double high = number("high");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Interval i = interval(*e);
    if (!j_.high || i.high > *j_.high) report(i);
    if (!i.known())
      verdicts.push_back(tooFew(e->name()));
    else
      verdicts.push_back(i.high < high ? Verdict::Agrees : i.low >= high ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

Verdict Judge::trend() {
  const std::string along = text("along", "");
  std::vector<double> x, y;
  for (const Evidence* e : conditions_) {
    const double varied = parameterOf(*e, along);
    if (!std::isfinite(varied)) return Verdict::Undecided;
    if (!estimate(*e).known()) return tooFew(e->name());
    for (const double v : values(*e)) x.push_back(varied), y.push_back(v);
  }
  const auto r = rankCorrelation(x, y);
  if (!r) return tooFew();
  const double degrees = static_cast<double>(x.size()) - 2;
  const double t = std::abs(*r) * std::sqrt(degrees / std::max(1e-12, 1 - *r * *r));
  j_.ours = *r;
  if (x.size() < 10) return tooFew();  // for fewer lives the rank correlation does not follow Student's t
  j_.p = 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), t));
  noteMeans();
  if (*j_.p >= kSignificant) return Verdict::Undecided;
  return agreesIf(*r * number("sign") > 0);
}

Verdict Judge::settled() {
  double largest = 0;
  for (const Evidence* e : conditions_) {
    if (e->lives.size() < 2) return tooFew(e->name());
    if (!e->end) {
      note(fmt::format("{} never settled", e->name()));
      return Verdict::Differs;
    }
    const double change = largestChangeAfter(e->averages, *e->end);
    if (change > largest) largest = change;
  }
  j_.ours = largest;
  return agreesIf(largest >= number("low", 0) && largest <= number("high"));
}

Verdict Judge::pool() {
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Groups groups = groupsOf(*e, measure_);
    const auto component = groups.size() > 1 ? varianceComponent({groups.begin(), groups.end()}) : std::nullopt;
    if (!component) {
      verdicts.push_back(tooFew(e->name()));
      continue;
    }
    if (component->test.p <= j_.p.value_or(1)) j_.p = component->test.p, j_.ours = component->share;
    if (component->test.p < kSignificant)
      note(fmt::format("{}: {:.0f} % of the variance", e->name(), 100 * component->share));
    const bool open = component->test.p >= kSignificant && mostShare(*component, groups) > 0.5;
    verdicts.push_back(open ? tooFew(e->name()) : agreesIf(component->test.p >= kSignificant));
  }
  return all(verdicts);
}

}  // namespace surefoot
