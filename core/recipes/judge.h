// SPDX-License-Identifier: GPL-3.0-or-later
// Judges one claim; a function a kind (see claim.h).
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

/// Of the share of drawn means in which something holds; NaN: no means could be drawn.
inline Verdict ofShare(double share) {
  return share >= 0.95 ? Verdict::Agrees : share < 0.05 ? Verdict::Differs : Verdict::Undecided;
}

class Judge {
 public:
  Judge(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence, std::uint64_t seed)
      : registry_(registry),
        claim_(claim),
        arguments_(claim.arguments),
        evidence_(evidence),
        random_(seed) {
    j_.id = claim.id, j_.says = claim.says;
    j_.thesis = arguments_.value("thesis", nlohmann::json());
  }

  Result<Judgement> judge();
  static const std::map<std::string, Verdict (Judge::*)()>& kinds();

 private:
  using Group = std::vector<const Evidence*>;

  // What the recipe says. A misfit is noted, and reported by judge().

  void complain(const std::string& key, const std::string& what);
  std::string text(const char* key, const char* otherwise);
  double number(const char* key, std::optional<double> otherwise = {});
  Group fitting(const std::string& pattern) const;
  /// All conditions that fit the patterns of a list, in the order of these.
  Group find(const char* key);
  /// The one condition that a row names.
  const Evidence* conditionOf(const nlohmann::json& row, const char* key);
  /// What a condition is compared with: the claim's reference, or its own.
  const Evidence* referenceOf(const Evidence& e);
  double parameterOf(const Evidence& e, const std::string& key);
  Verdict eachRow(const std::function<Verdict(const nlohmann::json& row)>& judgeRow);

  // What the lives say.

  std::vector<double> values(const Evidence& e) const;
  double mean(const Evidence& e) const { return surefoot::meanOf(values(e)); }
  Interval interval(const Evidence& e) const { return meanOf(e, measure_); }
  /// NaN: one of the two has a single life.
  double p(const Evidence& a, const Evidence& b);
  Interval change(const Evidence& reference, const Evidence& e);
  /// A change that verdicts can be made of: where the second is 0 in every life, and its share has no interval, that of
  /// the difference, in per cent of the reference.
  Interval judged(const Interval& change, const Evidence& reference, const Evidence& e);
  /// Whether p < .01 though the interval leaves both signs open, or there is none: p takes the lives for independent,
  /// their variances for equal and the end of learning for certain; the interval does not. Notes it.
  bool leavesZeroIn(const Evidence& reference, const Evidence& e);
  /// `f` of the means of a group, drawn as far from ours as the lives leave them uncertain. Empty if they are too few.
  std::vector<double> drawn(const Group& group, const std::function<double(const std::vector<double>&)>& f);
  /// In what share of them something holds; NaN if the lives are too few.
  double share(const Group& group, const std::function<bool(const std::vector<double>&)>& holds);
  void report(const Interval& i);
  void note(const std::string& words) { j_.note += (j_.note.empty() ? "" : "; ") + words; }
  /// Notes why there is no verdict: too few lives, a change of a reference that is 0, or one to 0.
  Verdict tooFew(const std::string& condition = "");
  /// Whether a change may be larger than `widest` (25 %) for all that the lives tell: down, up, or either.
  bool mayExceed(const Interval& change, bool down, bool up);
  /// Whether a claim of a change may be right though it is not significant: to that side the interval reaches beyond
  /// `widest`, or ours goes there and the interval reaches `size` per cent.
  bool leavesOpen(const Interval& change, double sign, double size);
  /// Of a number that shall lie between `low` and `high`.
  Verdict ofRange(const Interval& i);

  // The kinds.

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
  Verdict compromise();
  Verdict effectOrder();
  Verdict bandsOverlap();
  Verdict dips();
  void noteMeans();

  const Registry& registry_;
  const Claim& claim_;
  const nlohmann::json& arguments_;
  const std::vector<Evidence>& evidence_;
  Random random_;
  std::string measure_ = "falls", problem_;
  bool ofNothing_ = false, toNothing_ = false;  ///< the last change() was of a reference of 0; was to 0
  Group conditions_;
  Judgement j_;
};

}  // namespace surefoot
