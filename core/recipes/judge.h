// SPDX-License-Identifier: GPL-3.0-or-later
// Judges one claim; there is one function per kind (see claim.h).
#pragma once

#include <functional>
#include <map>

#include "core/recipes/claim.h"
#include "core/statistics/statistics.h"

namespace surefoot {

inline constexpr double kSignificant = 0.01;  // the thesis's

/// Several verdicts as one: all must agree, and one that differs is enough.
inline Verdict all(const std::vector<Verdict>& verdicts) {
  Verdict whole = Verdict::Agrees;
  for (const Verdict v : verdicts) {
    if (v == Verdict::Differs) return v;
    if (v == Verdict::Undecided) whole = v;
  }
  return whole;
}

inline Verdict agreesIf(bool condition) {
  return condition ? Verdict::Agrees : Verdict::Differs;
}

inline bool overlaps(const Interval& i, double low, double high) {
  return i.low <= high && i.high >= low;
}

/// The verdict from the share of drawn means in which the claim holds; NaN: no means could be drawn.
inline Verdict ofShare(double share) {
  return share >= 0.95 ? Verdict::Agrees : share < 0.05 ? Verdict::Differs : Verdict::Undecided;
}

class Judge {
 public:
  /// `system`: looks at the conditions of this system alone, by their names without it; 0: at all.
  Judge(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence, std::uint64_t seed,
        int system = 0)
      : registry_(registry),
        claim_(claim),
        arguments_(claim.arguments),
        evidence_(evidence),
        system_(system),
        random_(seed) {
    j_.id = claim.id, j_.says = claim.says, j_.counts = claim.counts;
    j_.thesis = arguments_.value("thesis", nlohmann::json());
    if (const auto p = arguments_.find("thesis_p"); p != arguments_.end()) j_.thesisP = p->get<double>();
  }

  Result<Judgement> judge();
  static const std::map<std::string, Verdict (Judge::*)()>& kinds();

 private:
  using Group = std::vector<const Evidence*>;

  // Reading the recipe. An error in it is noted, and reported by judge().

  void complain(const std::string& key, const std::string& what);
  std::string text(const char* key, const char* otherwise);
  double number(const char* key, std::optional<double> otherwise = {});
  bool flag(const char* key) const {
    const auto found = arguments_.find(key);
    return found != arguments_.end() && *found == true;
  }
  Group fitting(const std::string& pattern) const;
  /// All conditions that fit the patterns of a list, in the order of the patterns.
  Group find(const char* key);
  /// The one condition that a row names.
  const Evidence* conditionOf(const nlohmann::json& row, const char* key);
  /// The condition that `e` is compared with: the claim's reference, or its own.
  const Evidence* referenceOf(const Evidence& e);
  double parameterOf(const Evidence& e, const std::string& key);
  Verdict eachRow(const std::function<Verdict(const nlohmann::json& row)>& judgeRow);

  // Reading the lives.

  std::vector<double> values(const Evidence& e) const;
  double mean(const Evidence& e) const { return surefoot::meanOf(values(e)); }
  /// The mean; without an error where learning never ended and the measure goes up to its end: a life that was cut off
  /// is no life that was over (tooFew says so).
  MeanEstimate estimate(const Evidence& e);
  Interval interval(const Evidence& e) { return intervalOf(estimate(e)); }
  /// By their units (testOfUnits). NaN: one of the two has a single one.
  double p(const Evidence& a, const Evidence& b);
  Interval change(const Evidence& reference, const Evidence& e);
  /// The change for verdicts. If `e` is 0 in every life, the change has no interval: then the interval of the
  /// difference is taken, in per cent of the reference.
  Interval judged(const Interval& change, const Evidence& reference, const Evidence& e);
  /// Whether the interval contains 0 or is missing, although p < .01: p treats the lives as independent, their
  /// variances as equal and the end of learning as certain; the interval does not. Adds a note then.
  bool leavesZeroIn(const Evidence& reference, const Evidence& e);
  /// `f` of drawn means of a group (see drawMeans). Empty if there are too few lives.
  std::vector<double> drawn(const Group& group, const std::function<double(const std::vector<double>&)>& f);
  /// The share of drawn means in which `holds` is true; NaN if there are too few lives.
  double share(const Group& group, const std::function<bool(const std::vector<double>&)>& holds);
  /// The claim that of every pair of positions in `group` the first mean lies below the second, as one of `claims`:
  /// agrees if all do in 95 % of the means drawn; differs if one is the other way round in 1 − 5 %/claims.
  Verdict ofPairs(const Group& group, const std::vector<std::pair<std::size_t, std::size_t>>& pairs,
                  std::size_t claims);
  void report(const Interval& i);
  void note(const std::string& words) { j_.note += (j_.note.empty() ? "" : "; ") + words; }
  /// Notes why there is no verdict: too few lives, a change from a reference of 0, or a change to 0.
  Verdict tooFew(const std::string& condition = "");
  /// Whether the interval of a change reaches beyond `widest` (15 %) or is unknown: downwards, upwards, or either.
  bool mayExceed(const Interval& change, bool down, bool up);
  /// Whether a claimed change may be true although ours is not significant: on the side of `sign` the interval reaches
  /// beyond `widest`, or our change has this sign and the interval reaches `size` per cent.
  bool leavesOpen(const Interval& change, double sign, double size);
  /// The verdict on a number that shall lie between the arguments `low` and `high`.
  Verdict ofRange(const Interval& i, const std::string& condition = "");

  // The kinds.

  Verdict replication(const Interval& ours, double p);
  Verdict value();
  Verdict reduction();
  Verdict significant();
  Verdict noDifference();
  Verdict order();
  Verdict lowest();
  Verdict pairs();
  Verdict withinLives();
  Verdict notLonger();
  Verdict notWorse();
  Verdict ratio();
  Verdict extreme();
  Verdict below();
  Verdict trend();
  Verdict settled();
  Verdict pool();
  Verdict spread();
  Verdict rule();
  Verdict parameters();
  Verdict drawn();
  Verdict sameValues();
  Verdict best();
  Verdict chosen();
  Verdict equalExploring();
  Verdict addsUp();
  Verdict belowByOther(const Evidence& a, const std::string& measure, const Evidence& b, const std::string& other,
                       std::size_t claims);
  Verdict compromise();
  Verdict effectOrder();
  Verdict bandsOverlap();
  Verdict dips();
  void noteMeans();

  const Registry& registry_;
  const Claim& claim_;
  const nlohmann::json& arguments_;
  const std::vector<Evidence>& evidence_;
  const int system_;
  Random random_;
  std::string measure_ = "falls", problem_;
  bool ofNothing_ = false, toNothing_ = false;  ///< the last change() was from a reference of 0; was to 0
  std::string neverEnded_;                      ///< the last condition that estimate() found cut off
  Group conditions_;
  Judgement j_;
};

}  // namespace surefoot
