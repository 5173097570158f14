// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of text and code end at 120 columns.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = 120;

std::size_t columnsOf(const std::string& line) {
  const auto inside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };  // of a letter in UTF-8
  return line.size() - static_cast<std::size_t>(std::count_if(line.begin(), line.end(), inside));
}

/// Rows of tables, which Markdown cannot break.
bool mayBeLong(const fs::path& file, const std::string& line) {
  return file.extension() == ".md" && line.starts_with("|");
}

bool isText(const fs::path& file) {
  static const std::set<std::string> kEndings = {".h", ".cpp", ".c", ".in", ".md", ".txt", ".toml", ".sh", ".json"};
  const bool script = file.extension().empty() && file.filename() != "LICENSE";
  return kEndings.contains(file.extension()) || script;
}

}  // namespace

TEST(Lines, EndAt120Columns) {
  int files = 0;
  const auto check = [&](const fs::path& file) {
    if (!fs::is_regular_file(file) || !isText(file)) return;
    ++files;
    std::ifstream in(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
      EXPECT_TRUE(columnsOf(line) <= kMost || mayBeLong(file, line))
          << file.string() << ":" << number << " has " << columnsOf(line) << " columns";
  };
  const fs::path source = SUREFOOT_SOURCE;
  for (const auto& entry : fs::directory_iterator(source)) check(entry.path());
  for (const char* folder : {"core", "physics", "ui", "app", "resources", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(source / folder))
      if (entry.path().string().find("/fuzz/") == std::string::npos) check(entry.path());
  EXPECT_GT(files, 500);
}
