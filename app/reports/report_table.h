// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a reproduction's report, as HTML and as Markdown.
#pragma once

#include <string>

#include "core/findings/conditions_table.h"

namespace surefoot {

/// Text that HTML shows as it is.
std::string escapedForHtml(const std::string& text);
/// Text that does not end a cell of a Markdown table.
std::string escapedForMarkdown(std::string text);

std::string asHtml(const ConditionsTable& table);
std::string asMarkdown(const ConditionsTable& table);

}  // namespace surefoot
