// SPDX-License-Identifier: GPL-3.0-or-later
// Plans whose number of lives follows from what the lives show.
//
// lives = "decided": groups of lives are added until every comparison with a reference is decided: different, or the
// same within a margin. Looking more than once makes errors more likely, so a part of the level is spent at each look:
// with α(t) = level·ln(1 + (e − 1)t), t the share of the most lives (Lan & DeMets 1983, of Pocock's form), look k has
// α(t_k) − α(t_{k−1}), and the comparisons share it. By the union bound the chance that any of them is called
// different, or the same, wrongly is at most the level each, whatever the tests' correlation.
//
// [search]: a parameter of one condition takes several values, with common seeds; the better half lives on with twice
// as many lives each (successive halving; Karnin, Koren & Somekh 2013), until one is left. It and its reference then
// live lives of other seeds, from which alone is reported: the best of many is best by luck, too.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/plans/plan_file.h"

namespace surefoot {

struct DecidedLives {
  int atLeast = 20, atMost = 200, group = 20;  ///< lives a condition
  double level = 0.01;
  double widest = 15;                 ///< [% of the reference] the margin within which two are the same
  std::string measure = "all_falls";  ///< of a life; better one that does not end with learning

  /// The lives at which is looked.
  std::vector<int> looks() const;
  /// What every look may spend of the level, before the comparisons share it; as many as looks().
  std::vector<double> levels() const;
};

struct PlanSearch {
  std::string condition;  ///< whose parameter is sought
  std::string key;        ///< of the parameter
  double low = 0, high = 0;
  int values = 12;  ///< of the parameter that are tried
  bool logarithmic = true;
  int budget = 240;                      ///< lives of all candidates together
  int fresh = 40;                        ///< lives of the best and of its reference that are reported
  std::string minimise = "all_falls";    ///< a measure of a life …
  std::string keeping = "final_reward";  ///< … of those whose mean of this is no worse than the reference's …
  double worse = 2;                      ///< … by more than so many per cent of it
  std::vector<std::string> candidates;   ///< names of the conditions that the plan makes of it

  std::vector<std::string> valuesToTry() const;
  /// The lives that each candidate has lived when the rounds are over: [8, 16, 32] halves three times.
  std::vector<int> rounds() const;
};

struct PlanGrowth {
  std::optional<DecidedLives> decided;
  std::optional<PlanSearch> search;

  explicit operator bool() const { return decided || search; }
  /// The lives of each condition at first.
  int first() const { return decided ? decided->atLeast : search ? search->rounds().front() : 0; }
};

/// The settings of [decided] and [search]; an error names file and line.
Result<DecidedLives> readDecided(const std::vector<PlanSetting>& settings, const std::string& path);
Result<PlanSearch> readSearch(const std::vector<PlanSetting>& settings, const std::string& path);

/// For the store.
nlohmann::json growthAsJson(const PlanGrowth& growth);
/// nullopt: it is not what growthAsJson wrote.
std::optional<PlanGrowth> growthFromJson(const nlohmann::json& json);

}  // namespace surefoot
