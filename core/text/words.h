// SPDX-License-Identifier: GPL-3.0-or-later
// Words in sentences to a person.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surefoot {

/// The known word nearest to `word` by edit distance, or "" if none is near.
std::string nearestWord(std::string_view word, const std::vector<std::string>& known);

/// "a, b and c".
std::string joinWords(const std::vector<std::string>& words, std::string_view last = "and");

}  // namespace surefoot
