// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the declared texts as source that lupdate reads: tests/ui/language/update.sh.
#include <fmt/format.h>

#include <cstdio>

#include "core/files/limited_json.h"
#include "tests/full_registry.h"
#include "tests/ui/language/declared_texts.h"

int main() {
  using namespace surefoot;
  for (const std::string& text : declaredTexts(fullRegistry(), SUREFOOT_SOURCE "/resources/robots"))
    fmt::print("QT_TRANSLATE_NOOP(\"core\", {})\n", nlohmann::json(text).dump());
  return 0;
}
