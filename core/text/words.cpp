// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace surefoot {

namespace {
/// Letters that are missing, too many, others, or have changed places with their neighbours (Damerau 1964).
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, last, row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0u);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}
}  // namespace

std::string nearestWord(std::string_view word, const std::vector<std::string>& known) {
  if (word.size() < 2 || word.size() > 100) return "";
  std::string lower(word);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string& candidate : known)
    if (lower.size() >= 4 && candidate.starts_with(lower)) return candidate;
  std::string best;
  std::size_t bestDistance = std::max<std::size_t>(3, word.size() / 2);
  for (const std::string& candidate : known) {
    // The part behind the dot counts too: "temperature" is near to "policy.temperature".
    const auto dot = candidate.find('.');
    std::size_t distance = editDistance(lower, candidate);
    if (dot != std::string::npos) distance = std::min(distance, editDistance(lower, candidate.substr(dot + 1)) + 1);
    if (distance < bestDistance && distance < word.size()) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string joinWords(const std::vector<std::string>& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? fmt::format(" {} ", last) : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace surefoot
