// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/laboratory/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "core/experiment/rule_of_thumb.h"
#include "core/parameters.h"

namespace surefoot {

namespace {

constexpr double kSignificant = 0.01;  // the thesis's

/// Several verdicts as one: all must agree, and one that differs is enough.
Verdict all(const std::vector<Verdict>& verdicts) {
  Verdict whole = Verdict::Agrees;
  for (const Verdict v : verdicts) {
    if (v == Verdict::Differs) return v;
    if (v == Verdict::Undecided) whole = v;
  }
  return whole;
}

Verdict agreesIf(bool condition) {
  return condition ? Verdict::Agrees : Verdict::Differs;
}

bool overlaps(const Interval& i, double low, double high) {
  return i.low <= high && i.high >= low;
}

/// Of a share of resamples in which something holds (claims.md: 95 % and 5 %).
Verdict ofShare(double share) {
  return share >= 0.95 ? Verdict::Agrees : share < 0.05 ? Verdict::Differs : Verdict::Undecided;
}

}  // namespace

Verdict Judge::value() {
  const double thesis = number("thesis");
  const double within = number("within", std::abs(thesis) * number("tolerance", 0.1));
  const Interval i = interval(*conditions_[0]);
  report(i);
  return agreesIf(overlaps(i, thesis - within, thesis + within));
}

Verdict Judge::reduction() {
  const double thesis = number("thesis");
  const Evidence& e = *conditions_[0];
  const Evidence& reference = *referenceOf(e);
  const Interval i = change(reference, e);
  report(i);
  j_.p = p(reference, e);
  const bool direction = (i.value < 0) == (thesis < 0) && *j_.p < kSignificant;
  const bool size =
      arguments_.contains("at_least") ? std::abs(i.value) >= number("at_least") : overlaps(i, thesis - 10, thesis + 10);
  if (direction && !size) note("direction and significance agree, size differs");
  return agreesIf(direction && size);
}

Verdict Judge::significant() {
  const double sign = number("sign", -1);
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const double pValue = p(reference, *e);
    const bool holds = pValue < kSignificant && (mean(*e) - mean(reference)) * sign > 0;
    if (!holds) note(fmt::format("not {} (p {:.2g})", e->name(), pValue));
    if (pValue >= j_.p.value_or(0)) j_.p = pValue, report(change(reference, *e));
    verdicts.push_back(agreesIf(holds));
  }
  return all(verdicts);
}

Verdict Judge::noDifference() {
  const double widest = number("widest", 25);
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const double pValue = p(reference, *e);
    const Interval i = change(reference, *e);
    if (pValue <= j_.p.value_or(1)) j_.p = pValue, report(i);
    const bool wide = (i.high - i.low) / 2 > widest;
    if (pValue < kSignificant)
      note(fmt::format("{} differs by {:+.0f} % (p {:.2g})", e->name(), i.value, pValue));
    else if (wide)
      note(fmt::format("{}: too few lives to tell", e->name()));
    verdicts.push_back(pValue < kSignificant ? Verdict::Differs : wide ? Verdict::Undecided : Verdict::Agrees);
  }
  return all(verdicts);
}

Verdict Judge::order() {
  const double held = share(conditions_, [](const auto& m) { return std::is_sorted(m.begin(), m.end()); });
  j_.ours = held;
  noteMeans();
  return ofShare(held);
}

Verdict Judge::lowest() {
  const double held = share(conditions_, [](const auto& m) { return *std::min_element(m.begin(), m.end()) == m[0]; });
  j_.ours = held;
  noteMeans();
  return ofShare(held);
}

Verdict Judge::pairs() {
  std::vector<Verdict> verdicts;
  double least = 1;
  for (const auto& pair : arguments_.value("pairs", nlohmann::json::array())) {
    const bool two = pair.is_array() && pair.size() == 2 && pair[0].is_string() && pair[1].is_string();
    const Group first = two ? fitting(pair[0]) : Group{}, second = two ? fitting(pair[1]) : Group{};
    if (first.size() != 1 || second.size() != 1) {
      complain("pairs", fmt::format("{} are not two conditions", pair.dump()));
      return Verdict::Undecided;
    }
    const double held = share({first[0], second[0]}, [](const auto& m) { return m[0] < m[1]; });
    if (held < 0.95)
      note(fmt::format("{} {:.4g}, {} {:.4g}", first[0]->name(), mean(*first[0]), second[0]->name(), mean(*second[0])));
    least = std::min(least, held);
    verdicts.push_back(ofShare(held));
  }
  j_.ours = least;
  if (verdicts.empty()) complain("pairs", "a list of pairs of conditions is expected");
  return all(verdicts);
}

Verdict Judge::withinLives() {
  const std::string other = text("other", "");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const auto a = valuesOf(*e, measure_), b = valuesOf(*e, other);
    if (b.empty()) complain("other", fmt::format("it takes {}", joinWords(measureNames(), "or")));
    std::vector<double> differences;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      if (std::isfinite(a[i]) && std::isfinite(b[i])) differences.push_back(b[i] - a[i]);
    const auto i = meanInterval(differences);
    if (!i) {
      note(fmt::format("{}: too few lives have both", e->name()));
      verdicts.push_back(Verdict::Undecided);
      continue;
    }
    if (i->low <= 0) note(fmt::format("{}: {:+.3g} ({:+.3g} … {:+.3g})", e->name(), i->value, i->low, i->high));
    if (!j_.low || i->low < *j_.low) report(*i);
    verdicts.push_back(i->low > 0 ? Verdict::Agrees : i->high < 0 ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

Verdict Judge::notLonger() {
  measure_ = text("measure", "minutes");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Interval i = change(reference, *e);
    if (!j_.high || i.high > *j_.high) report(i);
    if (i.low > 0) note(fmt::format("{}: {:+.0f} % ({:+.0f} … {:+.0f})", e->name(), i.value, i.low, i.high));
    verdicts.push_back(i.low > 0 ? Verdict::Differs : i.high >= 25 ? Verdict::Undecided : Verdict::Agrees);
  }
  return all(verdicts);
}

Verdict Judge::notWorse() {
  const Evidence& first = *conditions_[0];
  bool better = false;
  for (const Evidence* e : conditions_) {
    if (e == &first) continue;
    const double pValue = p(first, *e);
    if (pValue >= kSignificant || mean(*e) >= mean(first)) continue;
    better = true;
    note(fmt::format("{} is better (p {:.2g})", e->name(), pValue));
    j_.p = std::min(pValue, j_.p.value_or(1));
  }
  report(interval(first));
  noteMeans();
  return agreesIf(!better);
}

Verdict Judge::ratio() {
  if (conditions_.size() != 2) complain("conditions", "two are expected");
  if (!problem_.empty()) return Verdict::Undecided;
  const Interval i = bootstrap(
      {groupsOf(*conditions_[0], measure_), groupsOf(*conditions_[1], measure_)},
      shareQFunctions(*conditions_[0], *conditions_[1]), [](const std::vector<double>& m) { return m[0] / m[1]; },
      random_);
  report(i);
  return agreesIf(overlaps(i, number("low"), number("high")));
}

Verdict Judge::extreme() {
  std::optional<Interval> most;
  std::string where;
  for (const Evidence* e : conditions_) {
    const Evidence& reference = *referenceOf(*e);
    if (e == &reference) continue;
    const Interval i = change(reference, *e);
    if (most && i.value >= most->value) continue;
    most = i, where = e->name();
  }
  if (!most) complain("conditions", "none has a reference");
  if (!problem_.empty()) return Verdict::Undecided;
  report(*most);
  note(where);
  return agreesIf(most->value >= number("low") && most->value <= number("high"));
}

Verdict Judge::below() {
  const double high = number("high");
  std::vector<Verdict> verdicts;
  for (const Evidence* e : conditions_) {
    const Interval i = interval(*e);
    if (!j_.high || i.high > *j_.high) report(i);
    verdicts.push_back(i.high < high ? Verdict::Agrees : i.low >= high ? Verdict::Differs : Verdict::Undecided);
  }
  return all(verdicts);
}

Verdict Judge::trend() {
  const std::string along = text("along", "");
  std::vector<double> x, y;
  for (const Evidence* e : conditions_) {
    const auto& parameters = e->configuration.value("parameters", nlohmann::json::object());
    if (!parameters.contains(along) || !parameters[along].is_number()) {
      complain("along", fmt::format("\"{}\" is no number of {}", along, e->name()));
      return Verdict::Undecided;
    }
    for (const double v : values(*e)) x.push_back(parameters[along]), y.push_back(v);
  }
  const auto r = rankCorrelation(x, y);
  if (!r) return Verdict::Undecided;
  const double degrees = static_cast<double>(x.size()) - 2;
  const double t = std::abs(*r) * std::sqrt(degrees / std::max(1e-12, 1 - *r * *r));
  j_.ours = *r;
  j_.p = 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(degrees), t));
  noteMeans();
  if (*j_.p >= kSignificant) return Verdict::Undecided;
  return agreesIf(*r * number("sign") > 0);
}

Verdict Judge::settled() {
  double largest = 0;
  for (const Evidence* e : conditions_) {
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
      verdicts.push_back(Verdict::Undecided);
      continue;
    }
    if (component->test.p <= j_.p.value_or(1)) j_.p = component->test.p, j_.ours = component->share;
    if (component->test.p < kSignificant)
      note(fmt::format("{}: {:.0f} % of the variance", e->name(), 100 * component->share));
    verdicts.push_back(agreesIf(component->test.p >= kSignificant));
  }
  return all(verdicts);
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
  j_.ours = held;
  noteMeans();
  return ofShare(held);
}

Verdict Judge::rule() {
  std::vector<Verdict> verdicts;
  for (const auto& row : arguments_.value("rows", nlohmann::json::array())) {
    const auto get = [&](const char* key, double otherwise) {
      const bool there = row.is_object() && row.contains(key) && row[key].is_number();
      return there ? row[key].get<double>() : otherwise;
    };
    const double expected = get("expected", std::nan("")), digits = get("digits", 0);
    const double ours =
        ruleOfThumb(get("discount", 0.98), get("transitions", std::nan("")), get("goal", 200), get("time", 0));
    if (!std::isfinite(ours) || !std::isfinite(expected)) {
      complain("rows", "transitions and expected are needed in each");
      return Verdict::Undecided;
    }
    note(fmt::format("{:.6g} for {:g}", ours, expected));
    if (!j_.ours) j_.ours = ours;
    // To the digits printed; a last digit may be cut instead of rounded.
    verdicts.push_back(agreesIf(std::abs(ours - expected) < std::pow(10.0, -digits)));
  }
  if (verdicts.empty()) complain("rows", "a list is expected");
  return all(verdicts);
}

void Judge::noteMeans() {
  std::vector<std::string> means;
  for (const Evidence* e : conditions_) means.push_back(fmt::format("{} {:.4g}", e->name(), mean(*e)));
  note(fmt::format("{}", fmt::join(means, ", ")));
}

}  // namespace surefoot
