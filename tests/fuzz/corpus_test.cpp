// SPDX-License-Identifier: GPL-3.0-or-later
// Bad files that fuzzing found worth keeping, and good ones to begin with.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/fuzz/use_file.h"

namespace surefoot {

TEST(Corpus, EveryFileIsReadOrRefusedWithASentence) {
  Registry registry;
  registerCore(registry);
  int files = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SUREFOOT_SOURCE "/tests/fuzz/corpus")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    useFile(registry, bytes);
    const auto parsed = TensorFile::parse(bytes, "file");
    if (!parsed) {
      EXPECT_TRUE(parsed.error().message.ends_with('.')) << entry.path() << ": " << parsed.error().message;
      ++refused;
    }
    ++files;
  }
  EXPECT_GT(files, 40);
  EXPECT_GT(refused, 20);
}

}  // namespace surefoot
