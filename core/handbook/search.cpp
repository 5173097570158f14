// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/search.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace surefoot {

namespace {

/// Letters of ASCII as small ones, others as they are; without the marks before what is no Markdown ("Sarsa\_2Q").
std::string small(std::string text) {
  std::erase(text, '\\');
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(c < 0x80 ? std::tolower(c) : c); });
  return text;
}

int timesIn(const std::string& text, const std::string& word) {
  int times = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++times;
  return times;
}

}  // namespace

std::vector<const HandbookPage*> pagesWith(const Handbook& handbook, const std::string& words) {
  constexpr int kTitle = 1000;
  std::vector<std::pair<int, const HandbookPage*>> found;
  for (const HandbookPage& page : handbook) {
    const std::string title = small(page.title), text = small(page.text);
    std::istringstream list(small(words));
    int weight = 0;
    bool all = true;
    for (std::string word; all && list >> word;) {
      const int times = kTitle * timesIn(title, word) + timesIn(text, word);
      all = times > 0;
      weight += times;
    }
    if (all) found.emplace_back(weight, &page);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const HandbookPage*> pages;
  for (const auto& [weight, page] : found) pages.push_back(page);
  return pages;
}

}  // namespace surefoot
