// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of robots; begin with resources/robots as the corpus.
#include <cstdint>

#include "tests/fuzz/use_robot.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  surefoot::useRobot({reinterpret_cast<const char*>(data), size});
  return 0;
}
