// SPDX-License-Identifier: GPL-3.0-or-later
// The TOML of a plan as lists of settings, before their meaning is looked at.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/basics/result.h"

namespace surefoot {

/// A setting, for example "set.policy.threshold": all its values, as text, and its line in the file.
struct PlanSetting {
  std::string key;
  std::vector<std::string> values;
  int line = 0;
};

/// The settings of one [[condition]], with the settings of [base] and [pre-learning] that it does not replace.
struct PlanBlock {
  std::vector<PlanSetting> settings;  ///< in the order of the file
  int line = 0;
};

struct PlanFile {
  std::vector<PlanSetting> head;  ///< title, seed, …
  std::vector<PlanBlock> blocks;
  std::vector<PlanSetting> systems, decided, search;  ///< of [systems], [decided] and [search]
  // Only in recipes.
  std::vector<std::string> shows;  ///< figures and tables of the thesis
  std::string answers;             ///< the question, in a sentence
  double minutesOnTwoCores = 0;    ///< measured; 0: nobody did
  double minutesForLives = 0;      ///< measured with this many lives per condition; 0: it holds for any number
};

Result<PlanFile> parsePlanFile(const std::string& text, const std::string& path);
/// The parts of a recipe besides its plan: {shows: […], figure: [{…}, …], claim: [{…}, …]}.
Result<nlohmann::json> parseRecipeBlocks(const std::string& text, const std::string& path);

/// "figure.toml, line 12: …"
Error planError(const std::string& path, int line, const std::string& sentence);

// The value of a setting, checked.
Status readNumber(const std::string& key, const std::string& text, double low, double high, std::optional<double>& out);
/// A whole number from 1 to `most`.
Status readCount(const std::string& key, const std::string& text, int most, int& out);
Status readCount(const std::string& key, const std::string& text, std::int64_t most, std::optional<std::int64_t>& out);
Status readSeed(const std::string& text, std::uint64_t& out);
/// true or false.
Status readFlag(const std::string& key, const std::string& text, bool& out);
/// "there is no …, did you mean …; it takes …"
Status unknownKey(const std::string& key, const std::vector<std::string>& known);

}  // namespace surefoot
