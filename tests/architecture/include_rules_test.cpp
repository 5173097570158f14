// SPDX-License-Identifier: GPL-3.0-or-later
// Dependencies run one way: app → ui → core, app → physics → core; ui and physics never meet. System headers are always
// on the path, so the compiler cannot say this.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace {

using std::filesystem::path;

void forbid(const std::string& folder, const std::string& pattern, const std::string& reason) {
  const std::regex include(R"(^\s*#\s*include\s*[<"])" + std::string("(") + pattern + ")");
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path(SUREFOOT_SOURCE) / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    ++files;
    std::ifstream in(entry.path());
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
      EXPECT_FALSE(std::regex_search(line, include)) << entry.path() << ":" << number << ": " << line << "\n" << reason;
  }
  EXPECT_GT(files, 0) << folder;
}

constexpr const char* kQt = "Q[A-Z]|Qt[A-Z]";
constexpr const char* kBox2d = "box2d";

}  // namespace

TEST(Includes, CoreKnowsNoOneElse) {
  forbid("core", kQt, "core/ must build without Qt");
  forbid("core", kBox2d, "core/ must build without Box2D");
  forbid("core", "(physics|ui|app)/", "core/ is the lowest layer");
  forbid("core", "CLI/", "command lines belong to app/");
}

TEST(Includes, PhysicsKnowsOnlyCore) {
  forbid("physics", kQt, "physics/ must build without Qt");
  forbid("physics", "(ui|app)/", "physics/ lies below");
}

TEST(Includes, UiKnowsOnlyCore) {
  forbid("ui", kBox2d, "ui/ draws a Scene, never Box2D");
  forbid("ui", "(physics|app)/", "ui/ sees environments through core/");
}
