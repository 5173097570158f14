// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the declared texts as source that lupdate reads: tests/ui/language/update.sh.
#include <fmt/format.h>

#include <cstdio>

#include "core/files/limited_json.h"
#include "tests/full_registry.h"
#include "tests/ui/language/declared_texts.h"

int main() {
  using namespace surefoot;
  const auto print = [](const char* context, const std::set<std::string>& texts) {
    for (const std::string& text : texts)
      fmt::print("QT_TRANSLATE_NOOP(\"{}\", {})\n", context, nlohmann::json(text).dump());
  };
  const Registry registry = fullRegistry();
  print("core", declaredTexts(registry, SUREFOOT_SOURCE "/resources/robots"));
  print("lessons", lessonTexts(registry, SUREFOOT_SOURCE "/resources/lessons"));
  return 0;
}
