// SPDX-License-Identifier: GPL-3.0-or-later
// Where two descriptions differ, for a message: one place with both values, because a sentence can hold no more.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace surefoot {

struct Difference {
  std::string where;         ///< "tilings of q"
  std::string theirs, ours;  ///< shortened
};

/// The first place where two descriptions differ; settings of a person come before others. A key that only `theirs` has
/// is no difference. Messages call the whole description `where`.
std::optional<Difference> firstDifference(const nlohmann::json& theirs, const nlohmann::json& ours,
                                          const std::string& where);

}  // namespace surefoot
