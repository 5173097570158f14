// SPDX-License-Identifier: GPL-3.0-or-later
// Reads any bytes as every text that people and files give: plans, recipes, JSON, assignments and numbers. Whatever the
// bytes, this must return.
#pragma once

#include "core/files/limited_json.h"
#include "core/recipes/recipe.h"
#include "core/text/latex.h"
#include "core/text/number_text.h"
#include "core/text/printable.h"
#include "core/text/shell_text.h"
#include "core/text/text.h"

namespace surefoot {

inline void useText(const Registry& registry, const std::string& text) {
  static_cast<void>(parseJson(text));
  static_cast<void>(static_cast<bool>(parseRecipe(registry, text, "plan.toml", {})));
  static_cast<void>(static_cast<bool>(parseNumbers("--state", text)));
  static_cast<void>(static_cast<bool>(parseSeed("--seed", text)));
  const auto equals = text.find('=');
  auto usual = configure(registry, {}, {});
  if (usual && equals != text.npos)
    static_cast<void>(
        static_cast<bool>(usual->parameters.set(text.substr(0, equals), std::string_view(text).substr(equals + 1))));
  static_cast<void>(latexText(text) + csvCell(text) + shellQuoted(text) + printable(text) +
                    std::string(shortened(text)));
}

}  // namespace surefoot
