// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook's pages in other languages say what the English ones say: headings, lists, tables, code and links are
// the same. Who changes a page is told here which others to change.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "core/handbook/handbook.h"
#include "core/handbook/written_pages.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

const std::string kWritten = SUREFOOT_SOURCE "/resources/handbook";

/// What pages of all languages have in common, a line each: headings, list items, rows, code without its comments.
std::string skeletonOf(const std::string& text) {
  static const std::regex kMark(R"(^\s*(#+ |- |\d+\. |\|).*)"), kComment(R"(^\s*(# .*)?$|\s+# .*$|\s+// .*$)");
  std::istringstream in(text);
  std::string skeleton;
  bool code = false;
  for (std::string line; std::getline(in, line);) {
    const bool fence = line.find("```") != std::string::npos;
    if (fence) code = !code;
    std::smatch mark;
    if (code || fence)
      skeleton += std::regex_replace(line, kComment, "") + "\n";
    else if (std::regex_match(line, mark, kMark))
      skeleton += mark[1].str() + "\n";
  }
  return std::regex_replace(skeleton, std::regex("\n+"), "\n");
}

std::vector<std::string> linksOf(const std::string& text) {
  static const std::regex kLink(R"(\]\(([^)]*)\)|<a name="[^"]*">)");
  std::vector<std::string> links;
  for (std::sregex_iterator at(text.begin(), text.end(), kLink), end; at != end; ++at) links.push_back(at->str());
  std::sort(links.begin(), links.end());
  return links;
}

class HandbookIn : public testing::TestWithParam<const char*> {};

}  // namespace

TEST_P(HandbookIn, HasEveryPageWithTheSameParts) {
  const auto english = writtenPages(kWritten), pages = writtenPages(kWritten, GetParam());
  ASSERT_TRUE(english && pages) << (pages ? "" : pages.error().message);
  ASSERT_EQ(pages->size(), english->size());
  for (std::size_t i = 0; i < pages->size(); ++i) {
    const HandbookPage &page = (*pages)[i], &original = (*english)[i];
    EXPECT_EQ(page.name, original.name);
    EXPECT_EQ(page.section, original.section);
    EXPECT_NE(page.text, original.text) << page.name << " is not translated";
    EXPECT_EQ(skeletonOf(page.text), skeletonOf(original.text)) << page.name;
    EXPECT_EQ(linksOf(page.text), linksOf(original.text)) << page.name;
  }
}

TEST_P(HandbookIn, HasNoFileOfNoPage) {
  for (const auto& file : std::filesystem::directory_iterator(kWritten + "/" + GetParam()))
    EXPECT_TRUE(std::filesystem::exists(kWritten + "/" + file.path().filename().string())) << file.path();
}

TEST_P(HandbookIn, LeadsNowhereWithoutAPage) {
  HandbookSpeech speech;
  speech.code = GetParam();
  const auto handbook = makeHandbook(fullRegistry(), kWritten, {}, speech);
  ASSERT_TRUE(handbook) << handbook.error().message;
  for (const std::string& broken : brokenLinks(*handbook, SUREFOOT_SOURCE "/resources/screenshots"))
    EXPECT_NE(broken.find("command-"), std::string::npos) << broken << ": commands are no pages here";
}

INSTANTIATE_TEST_SUITE_P(Languages, HandbookIn, testing::Values("nl", "de"));

}  // namespace surefoot
