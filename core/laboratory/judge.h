// SPDX-License-Identifier: GPL-3.0-or-later
// Judges one claim; a function a kind (see claim.h).
#pragma once

#include <functional>

#include "core/laboratory/claim.h"
#include "core/laboratory/statistics.h"

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

/// Of a share of resamples in which something holds.
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
        seed_(seed),
        random_(seed) {
    j_.id = claim.id, j_.says = claim.says;
    j_.thesis = arguments_.value("thesis", nlohmann::json());
  }

  Result<Judgement> judge();

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
  Interval interval(const Evidence& e) const { return meanOf(e, measure_, seed_); }
  double p(const Evidence& a, const Evidence& b);
  Interval change(const Evidence& reference, const Evidence& e);
  /// Of all these means, with the interval of its resamples.
  Interval statistic(const Group& group, const std::function<double(const std::vector<double>&)>& f);
  /// In what share of the resamples of all these means something holds.
  double share(const Group& group, const std::function<bool(const std::vector<double>&)>& holds);
  void report(const Interval& i) { j_.ours = i.value, j_.low = i.low, j_.high = i.high; }
  void note(const std::string& words) { j_.note += (j_.note.empty() ? "" : "; ") + words; }

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
  std::uint64_t seed_;
  Random random_;
  std::string measure_ = "falls", problem_;
  Group conditions_;
  Judgement j_;
};

}  // namespace surefoot
