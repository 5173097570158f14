// SPDX-License-Identifier: GPL-3.0-or-later
// The links and pictures in the HTML that MD4C makes. Any thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace surefoot {

/// The HTML with what `change` returns in place of where its links lead and of its pictures' files.
std::string withLinks(const std::string& html,
                      const std::function<std::string(std::string_view target, bool picture)>& change);

}  // namespace surefoot
