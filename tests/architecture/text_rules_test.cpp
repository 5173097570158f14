// SPDX-License-Identifier: GPL-3.0-or-later
// Text from outside goes through one door each: one parser with limits, and no widget that takes it for HTML.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace {

using std::filesystem::path;

/// No line of these folders matches, but in the files that may.
void forbid(const std::vector<std::string>& folders, const std::string& pattern, const std::set<std::string>& may) {
  const std::regex forbidden(pattern);
  std::set<std::string> found;
  for (const std::string& folder : folders)
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(SUREFOOT_SOURCE) / folder)) {
      const auto extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream in(entry.path());
      std::string line;
      for (int number = 1; std::getline(in, line); ++number) {
        if (!std::regex_search(line, forbidden)) continue;
        found.insert(entry.path().filename().string());
        EXPECT_TRUE(may.contains(entry.path().filename().string())) << entry.path() << ":" << number << ": " << line;
      }
    }
  EXPECT_EQ(found, may) << "what is allowed is there";
}

}  // namespace

TEST(TextFromOutside, HasOneParserEach) {
  forbid({"core", "app", "ui", "physics"}, R"((json|Json)::parse\()", {"limited_json.cpp"});
  forbid({"core", "app", "ui", "physics"}, R"(toml::parse\()", {"toml_parser.h"});
}

TEST(TextFromOutside, IsNoHtmlInTheWindow) {
  forbid({"ui"}, R"(Qt::RichText|setHtml\(|Qt::AutoText|insertHtml\(|appendHtml\()",
         {"experiment_page_results.cpp", "flat_style.cpp", "rule_view.cpp"});
}

// A text that a person reads goes through tr().
TEST(TextOfTheWindow, CanBeTranslated) {
  const std::string shows = R"(\b(setText|setToolTip|setWindowTitle|setAccessibleName|setAccessibleDescription|)"
                            R"(setPlaceholderText|setPrefix|setSuffix|setTitle|setNote|addAction|addMenu|addTab|)"
                            R"(addItem|drawText|announce)\()";
  forbid({"ui"}, shows + R"rx((QStringLiteral\(|QLatin1String\()?"[^"]*[A-Za-z]{3})rx", {});
  forbid({"ui"}, R"rx(\bError\{"[A-Z])rx", {});
}

// Each test is a process, and many run at once: a file in the common folder is another test's, too.
TEST(FilesOfTests, AreInFoldersOfTheirOwn) {
  forbid({"tests"}, R"(TempDir\(\)|temp_directory_path\(\)|mkdtemp\()", {"folder.h"});
}

// Two types of one name in one namespace are one type to the linker: their destructors are mixed up without a word.
TEST(Names, OfTypesInHeadersAreUnique) {
  const std::regex definition(R"(^(class|struct|enum class) (\w+)( .*)?$)");
  std::map<std::string, path> seen;
  for (const char* folder : {"core", "app", "ui", "physics"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path(SUREFOOT_SOURCE) / folder)) {
      if (entry.path().extension() != ".h") continue;
      std::ifstream in(entry.path());
      std::smatch match;
      for (std::string line; std::getline(in, line);) {
        if (!std::regex_search(line, match, definition)) continue;
        const auto [before, isNew] = seen.emplace(match[2], entry.path());
        EXPECT_TRUE(isNew) << match[2] << " is in " << before->second << " and in " << entry.path();
      }
    }
  EXPECT_GT(seen.size(), 100u);
}
