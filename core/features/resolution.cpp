// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/features/resolution.h"

#include <algorithm>
#include <cctype>

namespace surefoot {

std::string capitalised(std::string title) {
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string shortLabel(const std::string& word, const StateVariable& variable) {
  return variable.symbol.empty() ? word + " " + variable.title : word;  // the symbol stands behind the label anyway
}

Parameter resolutionParameter(const StateVariable& v, std::string help, std::string origin) {
  return {.key = v.key,
          .title = capitalised(v.title),
          .symbol = v.symbol,
          .unit = v.perSpan,
          .low = 0.01,
          .high = 1000,
          .sliderLow = std::min(1.0, v.resolution),
          .sliderHigh = 32,
          .when = When::NewTable,
          .group = Group::Representation,
          .help = std::move(help),
          .origin = std::move(origin)};
}

Parameter factorParameter(std::string key, std::string title, std::string help, std::string origin) {
  return {.key = std::move(key),
          .title = std::move(title),
          .unit = "×",
          .low = 0.01,
          .high = 100,
          .sliderLow = 0.1,
          .sliderHigh = 2,
          .when = When::NewTable,
          .group = Group::Representation,
          .help = std::move(help),
          .origin = std::move(origin),
          .order = 2};
}

}  // namespace surefoot
