// SPDX-License-Identifier: GPL-3.0-or-later
// A claim of the thesis, and whether our lives bear it out. Kinds, and when each agrees:
//
//   value         the 95 % interval of a mean overlaps the thesis's number ± tolerance (a share of it, 10 %) or ±
//                 within; undecided where the interval is wider than ± 2.5 times that
//   reduction     of the mean against the reference, in per cent. With the thesis's p (`thesis_p`, of `thesis_lives` a
//                 side): agrees if ours has its direction (p < .01) and the two studies' difference is within 1.96
//                 standard errors (Higgins & Thomas 2023, Cochrane handbook, 6.3.1: the error from p); differs beyond
//                 that, or in the other direction; else undecided. Without it: the thesis's sign, p < .01, and an
//                 interval that overlaps the number ± 10 points (or ours is at least `at_least`)
//   significant   the sign and p < .01, for every condition
//   no-difference equivalence: the interval lies within ± `widest` (15 % of the reference), for every condition;
//                 differs with p < .01/(number of conditions) and an interval without 0; else undecided
//   order         the means rise in the order of `conditions` in at least 95 % of the means drawn; differs if one pair
//                 of neighbours is the other way round, in 1 − 5 %/(number of pairs) of them
//   lowest        the first of `conditions` has the lowest mean of all, likewise against each other one
//   spread        the means of `conditions` lie closer together than those of `others` (`relative`: by their ratio), in
//                 at least 95 % of the means drawn; differs below 5 %
//   pairs         the mean of every first is below that of its second (by the measure `other`, if there is one), as in
//                 an order: `pairs` = [[first, second], …]
//   adds-up       the best values of the parameters `alongs`, each found while the others stay as in the first
//   condition,
//                 do worse together than the best of all conditions (p < .01), which are their grid: chosen by one half
//                 of the units, measured with the other; differs if they are the best, or no worse by `widest`
//   within-lives  of two measures of one life, `measure` is on the mean below `other`, for every condition
//   not-longer    the interval of the difference from the reference is not wholly above 0; undecided if it reaches 15 %
//   not-worse     no condition is significantly below the first (p < .01/(number of others)); undecided if one may be
//   by `widest` ratio         mean(first)/mean(second) lies in low … high, its interval is no wider; differs if that
//   lies outside;
//                 `conditions` in pairs
//   extreme       the largest reduction of all conditions in per cent, likewise: chosen by one half of the units and
//                 measured with the other
//   equal-exploring  `conditions` fall less (`sign` 1: more) than `others` at the same share of exploring, on the line
//                 between the two of them next to it: agrees if the 99 % interval says so; differs if it says the
//                 reverse, or the 95 % interval lies within `widest`; undecided beyond what `others` explore
//   below         the interval of the mean lies below `high`, for every condition
//   trend         values of lives against what `along` varied: the rank correlation has the sign of `sign`, p < .01
//   settled       the largest 250-episode change behind the end of learning lies between low and high
//   pool          lives of one Q-function are no more alike than all (F test, p ≥ .01); undecided where more than half
//                 of the variance may yet lie between Q-functions
//   compromise    no condition is significantly below the first in both `measure` and `other`; undecided if one may be
//   effect-order  `conditions` in pairs: the first of a pair gains less on its reference than the second on its own, in
//                 standard deviations (`relative`: in per cent)
//   best          of each of `groups` (lists of conditions) the one with the lowest mean: its value of the parameter
//                 `along` is the same in all (the intervals overlap, none of them takes in more than half of the
//                 values), or that of the first is `relation` = lower or not-lower than those of the others; of one
//                 group: its interval holds the thesis's value, and no more than half of the values
//   chosen        of every `of` (5) lives in a row the one is chosen with the lowest (`choose` = highest) `other` in
//   the
//                 condition `by`, where life i has the same Q-function; its `measure` in the first of `conditions`
//                 against the mean of its row: agrees if it has the sign of `sign` with p < .01 (pairs of rows);
//                 differs the other way round, or within `widest`
//   bands-overlap the 95 % bands of the learning curve and of the reference's overlap at 95 % of all moments; undecided
//                 where they are wider than half of what the curve reaches
//   dips          the average reward falls below that of the `first` episodes (10), where is found by one half of the
//                 units and measured with the other
//
// p is that of the units (testOfUnits): pairs of lives or of Q-functions where both conditions have the same, means of
// Q-functions where lives share them, and only else the thesis's analysis of variance of the lives.
//
// A condition whose learning never ended was cut off: what is measured up to the end has no interval there, and its
// claims are undecided. On many systems ([systems] of a plan) a claim is judged on each (judge_systems.h).
//
// A claim is undecided where the lives cannot decide it: one life never can. A reduction or significance with p ≥ .01
// is undecided if its interval leaves it open (beyond `widest`, or on the thesis's side up to its number or `at_least`,
// or 10 %); with p < .01, if its interval contains 0: the analysis of variance treats lives of one Q-function as
// independent, the interval does not. Lives that are 0 throughout are judged by the difference, whose interval is
// known.
//
// Exact, from the configurations of conditions and not from their lives; `rows`, all of which must hold:
//
//   same-values   taught by one stream of `steps` transitions (10⁵), two conditions' values differ by less than
//                 `within` (1e-9); it has no rows
//   rule          the rule of thumb (eq. 4.3): {discount, transitions, goal, time, expected, digits}
//   parameters    key·times/over, the last of condition `of`: {condition, key, times, over, of, expected, digits}
//   drawn         a point of the figure `draws` (a kind of live figure, with its `q` or `state`): {condition, x,
//                 expected, within} or {condition, x, low, high}
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/findings/evidence.h"
#include "core/registry.h"

namespace surefoot {

/// A claim as a recipe states it.
struct Claim {
  std::string id, kind, says;
  nlohmann::json arguments;  ///< thesis, conditions, measure, …
  bool calibrated = false;   ///< the default preset was fitted to it: judged on the lab preset, too
  /// What an agreement is worth: "test" (it could have failed), "fitted", "arithmetic" (exact kinds), "implied" (the
  /// thesis does not print the number, it follows from others that it prints) or "question" (the thesis asks).
  std::string counts = "test";
};

enum class Verdict { Agrees, Differs, Undecided };
const char* nameOf(Verdict verdict);

struct Judgement {
  std::string id, says, note;
  std::string counts = "test";               ///< see Claim
  nlohmann::json thesis;                     ///< a number, a text or null
  std::optional<double> thesisP;             ///< that the thesis prints with it
  std::optional<double> ours, low, high, p;  ///< p: the worst of several
  Verdict verdict = Verdict::Undecided;
};

/// `conditions` may hold patterns, "TRL *". An error names the claim and what is wrong with it.
Result<Judgement> judge(const Registry& registry, const Claim& claim, const std::vector<Evidence>& evidence,
                        std::uint64_t seed);

nlohmann::ordered_json judgementAsJson(const Judgement& judgement);

/// Whether the claim's kind exists.
Status checkKind(const Claim& claim);

/// Whether a name fits a pattern, in which * stands for anything.
bool fits(std::string_view name, std::string_view pattern);
/// Whether a condition fits one of the claim's `conditions`.
bool isAbout(const Claim& claim, std::string_view condition);

}  // namespace surefoot
