// SPDX-License-Identifier: GPL-3.0-or-later
// The one way in for JSON that comes from outside: files, stores, settings. JSON that is deeply nested costs stack
// wherever it is copied or compared, so its depth is counted before it is parsed. Any thread.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace surefoot {

inline constexpr int kDeepestJson = 32;                 ///< levels of {} and []
inline constexpr std::size_t kLongestJson = 16u << 20;  ///< [bytes]

/// The value, or a discarded one (`is_discarded()`) if the text is no JSON, is nested deeper than kDeepestJson or is
/// longer than `longest`. Never throws for what the text holds.
nlohmann::json parseJson(std::string_view text, std::size_t longest = kLongestJson);

}  // namespace surefoot
