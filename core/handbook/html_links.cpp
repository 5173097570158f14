// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/handbook/html_links.h"

#include <algorithm>

namespace surefoot {

// A quotation mark in a text is &quot;, so these words stand in tags only.
std::string withLinks(const std::string& html,
                      const std::function<std::string(std::string_view target, bool picture)>& change) {
  constexpr std::string_view kLink = "<a href=\"", kPicture = "<img src=\"";
  std::string out;
  for (std::size_t from = 0; from < html.size();) {
    const std::size_t link = html.find(kLink, from), picture = html.find(kPicture, from);
    const bool isPicture = picture < link;
    const std::size_t at = std::min(link, picture);
    if (at == std::string::npos) return out + html.substr(from);
    const std::size_t begin = at + (isPicture ? kPicture : kLink).size();
    const std::size_t end = std::min(html.find('"', begin), html.size());
    out += html.substr(from, begin - from) + change(std::string_view(html).substr(begin, end - begin), isPicture);
    from = end;
  }
  return out;
}

}  // namespace surefoot
