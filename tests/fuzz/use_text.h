// SPDX-License-Identifier: GPL-3.0-or-later
// Reads any bytes as every text that people and files give: plans, recipes, JSON, assignments and numbers. Whatever the
// bytes, this must return.
#pragma once

#include "core/expression/compile.h"
#include "core/files/limited_json.h"
#include "core/lessons/handed_in/hand_in.h"
#include "core/lessons/reading/lesson_reading.h"
#include "core/recipes/recipe.h"
#include "core/text/latex.h"
#include "core/text/number_text.h"
#include "core/text/printable.h"
#include "core/text/shell_text.h"
#include "core/text/text.h"

namespace surefoot {

/// Takes every name.
class EveryName : public Vocabulary {
 public:
  Result<Quantity> find(std::string_view name, std::optional<std::string_view> argument) const override {
    return Quantity{static_cast<int>((name.size() + argument.value_or("").size()) % 4)};
  }
  std::vector<std::string> names() const override { return {}; }
  bool chance() const override { return true; }
};

inline void useExpression(const std::string& text) {
  constexpr double kValues[] = {0.0, -1.5, 1e300, -kInfinity};
  Random random(1);
  for (const ValueKind wanted : {ValueKind::Number, ValueKind::Condition, ValueKind::Flag})
    if (const auto compiled = compile(text, wanted, EveryName())) compiled->evaluate(kValues, &random);
}

inline void useText(const Registry& registry, const std::string& text) {
  static_cast<void>(parseJson(text));
  static_cast<void>(static_cast<bool>(parseRecipe(registry, text, "plan.toml", {})));
  static_cast<void>(static_cast<bool>(parseNumbers("--state", text)));
  static_cast<void>(static_cast<bool>(parseSeed("--seed", text)));
  useExpression(text);
  std::vector<Complaint> complaints;
  static_cast<void>(readLesson(registry, text, "lesson.toml", complaints));
  if (const auto handIn = parseHandIn(text)) static_cast<void>(handIn->finished());
  const auto equals = text.find('=');
  auto usual = configure(registry, {}, {});
  if (usual && equals != text.npos)
    static_cast<void>(
        static_cast<bool>(usual->parameters.set(text.substr(0, equals), std::string_view(text).substr(equals + 1))));
  static_cast<void>(latexText(text) + csvCell(text) + shellQuoted(text) + printable(text) +
                    std::string(shortened(text)));
}

}  // namespace surefoot
