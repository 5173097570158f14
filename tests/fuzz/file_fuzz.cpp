// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer target for everything that reads files.
//   cmake -B build/fuzz -DSUREFOOT_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++ -DSUREFOOT_UI=OFF
//   build/fuzz/tests/fuzz/file_fuzz -max_total_time=600 -max_len=60000 NEW_FOLDER tests/fuzz/corpus
#include "core/register/register.h"
#include "tests/fuzz/use_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const surefoot::Registry registry = [] {
    surefoot::Registry r;
    surefoot::registerCore(r);
    return r;
  }();
  surefoot::useFile(registry, std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
