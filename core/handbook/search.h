// SPDX-License-Identifier: GPL-3.0-or-later
// Looks for words in the handbook. Any thread.
#pragma once

#include "core/handbook/page.h"

namespace surefoot {

/// The pages in which every word stands, in any case and as a part of longer words: those with one in the title first,
/// then by how often they stand there. Without a word: all, in their order.
std::vector<const HandbookPage*> pagesWith(const Handbook& handbook, const std::string& words);

}  // namespace surefoot
