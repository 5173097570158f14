// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace surefoot {

namespace {
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
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
