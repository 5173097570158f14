// SPDX-License-Identifier: GPL-3.0-or-later
// The texts that the core declares and the window shows, each by itself: "Pole angle", not "Q⁺ Pole angle, from"; and
// those of lessons.
#pragma once

#include <set>
#include <string>

#include "core/registry.h"

namespace surefoot {

/// `robots`: the folder of the robots that come with the program; of these, titles and sentences about them.
std::set<std::string> declaredTexts(const Registry& registry, const std::string& robots);

/// The texts of a folder's lessons, each a whole.
std::set<std::string> lessonTexts(const Registry& registry, const std::string& lessons);

}  // namespace surefoot
