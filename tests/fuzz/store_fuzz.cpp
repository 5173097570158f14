// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target for stores: their values and their pages. As file_fuzz, with the corpus tests/fuzz/stores.
#include "core/register/register.h"
#include "tests/fuzz/use_store.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const surefoot::Registry registry = [] {
    surefoot::Registry r;
    surefoot::registerCore(r);
    return r;
  }();
  surefoot::useStore(registry, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
