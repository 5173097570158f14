// SPDX-License-Identifier: GPL-3.0-or-later
// Bad files that fuzzing found worth keeping, and good ones to begin with.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/register/register.h"
#include "tests/fuzz/use_file.h"
#include "tests/fuzz/use_store.h"
#include "tests/fuzz/use_text.h"

namespace surefoot {

namespace {

/// Calls f with the content of every file of a folder; how many there are.
template <class F>
int forEach(const std::string& folder, F f) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SUREFOOT_SOURCE "/tests/fuzz/" + folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    f(entry.path().filename().string(), std::string{std::istreambuf_iterator<char>(in), {}});
    ++files;
  }
  return files;
}

}  // namespace

TEST(Corpus, EveryStoreIsReadOrRefused) {
  Registry registry;
  registerCore(registry);
  const int stores = forEach("stores", [&](const std::string& name, const std::string& bytes) {
    EXPECT_EQ(useStore(registry, bytes), name.starts_with("nothing")) << name;
  });
  EXPECT_GT(stores, 10);
}

TEST(Corpus, EveryTextIsReadOrRefused) {
  Registry registry;
  registerCore(registry);
  EXPECT_GT(forEach("texts", [&](const std::string&, const std::string& text) { useText(registry, text); }), 10);
}

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
