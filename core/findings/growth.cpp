// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/findings/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/statistics/statistics_text.h"

namespace surefoot {

namespace {

/// Lives that were lived, those that diverged, too.
int livedBy(const Evidence& e) {
  return static_cast<int>(e.lives.size()) + e.record.diverged;
}

/// ", −45.0 % (−55.1 … −32.0)"
std::string changeWords(const Interval& change) {
  const std::string text = changeText(change, 1);
  const auto end = text.find(' ');
  return text.empty() ? "" : ", " + text.substr(0, end) + " %" + (end == std::string::npos ? "" : text.substr(end));
}

Interval changeBetween(const Evidence& reference, const Evidence& e, std::string_view measure) {
  return changeOf(estimateOf(reference, measure), estimateOf(e, measure), sameUnits(reference, e));
}

/// The comparisons of a plan, and the lives that its conditions want.
class Growing {
 public:
  explicit Growing(const std::vector<Evidence>& evidence) : evidence_(evidence) {
    for (const Evidence& e : evidence) state_.lives.push_back(e.record.condition.lives);
  }

  std::size_t numberOf(const std::string& name) const {
    const auto found =
        std::find_if(evidence_.begin(), evidence_.end(), [&](const auto& e) { return e.name() == name; });
    return static_cast<std::size_t>(found - evidence_.begin());
  }

  /// Whether a condition has this many lives; otherwise it wants them.
  bool has(std::size_t condition, int lives) {
    int& wanted = state_.lives[condition];
    wanted = std::max(wanted, lives);
    return livedBy(evidence_[condition]) >= lives;
  }

  const std::vector<Evidence>& evidence_;
  GrowthState state_;
};

GrowthState decidedOf(const DecidedLives& plan, const std::vector<Evidence>& evidence) {
  Growing growing(evidence);
  struct Pair {
    std::size_t reference, condition;
    Decision decision = Decision::Open;
    int after = 0;
    Interval change{};
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const std::size_t reference = growing.numberOf(evidence[i].record.condition.reference);
    if (reference < evidence.size() && reference != i) pairs.push_back({reference, i});
  }
  const std::vector<int> looks = plan.looks();
  const std::vector<double> levels = plan.levels();
  for (std::size_t k = 0; k < looks.size(); ++k) {
    bool there = true, open = false;
    for (const Pair& p : pairs) {
      if (p.decision != Decision::Open) continue;
      open = true;
      const bool first = growing.has(p.reference, looks[k]), second = growing.has(p.condition, looks[k]);
      there = there && first && second;
    }
    if (!open) break;
    if (!there) return growing.state_;
    for (Pair& p : pairs) {
      if (p.decision != Decision::Open) continue;
      const Evidence reference = livesOf(evidence[p.reference], 0, looks[k]);
      const Evidence e = livesOf(evidence[p.condition], 0, looks[k]);
      p.decision = decide(reference, e, plan.measure, levels[k] / static_cast<double>(pairs.size()), plan.widest);
      p.after = looks[k];
      p.change = changeBetween(reference, e, plan.measure);
    }
  }
  constexpr const char* kWords[] = {"not decided", "fewer", "more", "the same"};
  for (const Pair& p : pairs) {
    const std::string margin = p.decision == Decision::Equivalent ? fmt::format(" within {:g} %", plan.widest) : "";
    growing.state_.sentences.push_back(fmt::format("{} against {}: {}{} after {} lives ({}{})",
                                                   evidence[p.condition].name(), evidence[p.reference].name(),
                                                   kWords[static_cast<int>(p.decision)], margin, p.after,
                                                   measureTitle(plan.measure, evidence), changeWords(p.change)));
  }
  return growing.state_;
}

GrowthState searchOf(const PlanSearch& plan, const std::vector<Evidence>& evidence) {
  Growing growing(evidence);
  std::vector<std::size_t> left;
  for (const std::string& name : plan.candidates)
    if (const std::size_t number = growing.numberOf(name); number < evidence.size()) left.push_back(number);
  if (left.empty()) return growing.state_;
  const std::size_t reference = growing.numberOf(evidence[left[0]].record.condition.reference);
  const bool compared = reference < evidence.size();
  const std::vector<int> rounds = plan.rounds();
  for (const int lives : rounds) {
    bool there = !compared || growing.has(reference, lives);
    for (const std::size_t c : left) there = growing.has(c, lives) && there;
    if (!there) return growing.state_;
    const auto meanOfLives = [&](std::size_t c, const std::string& measure) {
      return estimateOf(livesOf(evidence[c], 0, lives), measure).value;
    };
    const double kept = compared ? meanOfLives(reference, plan.keeping) : std::nan("");
    const double least = kept - plan.worse / 100 * std::abs(kept);
    // Those that keep the end performance come first, the fewest falls first among them; ties by their order.
    std::vector<std::pair<bool, double>> ranks(evidence.size());
    for (const std::size_t c : left) {
      const double value = meanOfLives(c, plan.minimise);
      ranks[c] = {meanOfLives(c, plan.keeping) < least,
                  std::isfinite(value) ? value : std::numeric_limits<double>::infinity()};
    }
    std::stable_sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
    left.resize((left.size() + 1) / 2);
    if (left.size() == 1) break;
  }
  const std::size_t best = left[0];
  const int before = rounds.back(), after = before + plan.fresh;
  bool there = !compared || growing.has(reference, after);
  there = growing.has(best, after) && there;
  if (!there) return growing.state_;
  std::string sentence = fmt::format("the best of {} is {}, chosen by {} in {} lives", plan.candidates.size(),
                                     evidence[best].name(), measureTitle(plan.minimise, evidence), before);
  if (compared) {
    const Evidence from = livesOf(evidence[reference], before, after), to = livesOf(evidence[best], before, after);
    sentence +=
        fmt::format("; in {} others against {}: {:.4g} and {:.4g}{}; {} {:.4g} and {:.4g}", plan.fresh,
                    evidence[reference].name(), meanOf(from, plan.minimise).value, meanOf(to, plan.minimise).value,
                    changeWords(changeBetween(from, to, plan.minimise)), measureTitle(plan.keeping, evidence),
                    meanOf(from, plan.keeping).value, meanOf(to, plan.keeping).value);
  }
  growing.state_.sentences = {sentence};
  return growing.state_;
}

}  // namespace

Decision decide(const Evidence& reference, const Evidence& e, std::string_view measure, double level, double widest) {
  const auto test = testOfUnits(reference, e, measure);
  const MeanEstimate before = estimateOf(reference, measure), after = estimateOf(e, measure);
  if (test && test->p < level) return after.value < before.value ? Decision::Fewer : Decision::More;
  const Interval change = changeOf(before, after, sameUnits(reference, e), 1 - 2 * level);
  return change.known() && change.low > -widest && change.high < widest ? Decision::Equivalent : Decision::Open;
}

GrowthState growthOf(const PlanGrowth& growth, const std::vector<Evidence>& evidence) {
  return growth.decided ? decidedOf(*growth.decided, evidence) : searchOf(*growth.search, evidence);
}

}  // namespace surefoot
