// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target for texts: plans, recipes, JSON, --set and --state. As file_fuzz, with the corpus tests/fuzz/texts.
#include "core/register/register.h"
#include "tests/fuzz/use_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const surefoot::Registry registry = [] {
    surefoot::Registry r;
    surefoot::registerCore(r);
    return r;
  }();
  surefoot::useText(registry, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
