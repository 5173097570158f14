// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing that the program has is without a page, and every page is what its file says.
#include "core/handbook/handbook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/files/whole_file.h"
#include "core/handbook/declared_pages.h"
#include "core/handbook/html.h"
#include "core/handbook/html_links.h"
#include "core/handbook/search.h"
#include "core/handbook/written_pages.h"
#include "core/lessons/reading/step_reading.h"
#include "tests/folder.h"
#include "tests/full_registry.h"

namespace surefoot {

namespace {

const std::string kPages = SUREFOOT_SOURCE "/resources/handbook", kPictures = SUREFOOT_SOURCE "/resources/screenshots";

const std::vector<CommandHelp> kCommand = {{.name = "train", .summary = "learn without a window"}};

const Handbook& handbook() {
  static const Handbook pages = [] {
    auto made = makeHandbook(fullRegistry(), kPages, kCommand);
    EXPECT_TRUE(made) << made.error().message;
    return made ? *made : Handbook{};
  }();
  return pages;
}

std::vector<std::string> namesOf(const std::vector<const HandbookPage*>& pages) {
  std::vector<std::string> names;
  for (const HandbookPage* page : pages) names.push_back(page->name);
  return names;
}

const Handbook kSmall = {
    {"one", "First steps", "The beginning", "Tiles and [two](two). A picture: ![p](window-light.png)"},
    {"two", "First steps", "Tiles", "## <a name=\"there\"></a>There\n\ntiles tiles tiles ε-greedy"}};

}  // namespace

TEST(Handbook, EverythingByNameHasAPageWithItsMeaning) {
  const Registry registry = fullRegistry();
  const auto expectPage = [](const std::string& name, const Named& entry) {
    const HandbookPage* page = pageNamed(handbook(), name);
    ASSERT_TRUE(page) << name;
    EXPECT_EQ(page->title, entry.title);
    EXPECT_NE(page->text.find("Source: "), std::string::npos) << name;
  };
  for (const auto& entry : registry.policies) expectPage(methodPage(entry.name), entry);
  for (const auto& entry : registry.agents) expectPage(methodPage(entry.name), entry);
  for (const auto& entry : registry.features) expectPage(methodPage(entry.name), entry);
  for (const auto& entry : registry.environments) expectPage(worldPage(entry.name), entry);
}

TEST(Handbook, EveryPanelHasAPage) {
  for (const std::string& panel : lessonPanels()) {
    const HandbookPage* page = pageNamed(handbook(), "panel-" + panel);
    ASSERT_TRUE(page) << panel;
    EXPECT_EQ(page->section, "Panels");
    EXPECT_GT(page->text.size(), 400u) << panel;
  }
}

TEST(Handbook, ItsSectionsFollowEachOtherAndNoneIsEmpty) {
  std::vector<std::string> sections;
  std::set<std::string> names;
  for (const HandbookPage& page : handbook()) {
    if (sections.empty() || sections.back() != page.section) sections.push_back(page.section);
    EXPECT_TRUE(names.insert(page.name).second) << "two pages are called " << page.name;
  }
  EXPECT_EQ(sections, std::vector<std::string>(handbookSections().begin(), handbookSections().end()));
}

TEST(Handbook, TheFormatOfRobotsIsAPage) {
  const HandbookPage* page = pageNamed(handbook(), "robot-format");
  ASSERT_TRUE(page);
  EXPECT_NE(page->text.find("## [joint.NAME]"), std::string::npos);
  EXPECT_EQ(page->text.find("include:"), std::string::npos);
}

TEST(Handbook, BrokenLinksAreFound) {
  EXPECT_TRUE(brokenLinks(kSmall, kPictures).empty());
  Handbook broken = kSmall;
  broken[0].text = "[a](three), [b](two#here), [c](two#there), [d](https://www.debian.org), ![e](no.png), `[f](four)`";
  EXPECT_EQ(brokenLinks(broken, kPictures), (std::vector<std::string>{"one: three", "one: two#here", "one: no.png"}));
}

TEST(Handbook, APageThatIsNoneIsRefusedWithItsFile) {
  const auto refused = [](const std::string& text, const std::string& word) {
    const auto page = parsePage(text, "/pages/07-what.md");
    ASSERT_FALSE(page) << text;
    EXPECT_NE(page.error().message.find("07-what.md"), std::string::npos);
    EXPECT_NE(page.error().message.find(word), std::string::npos) << page.error().message;
  };
  refused("# Title\ntext", "first line");
  refused("<!-- section: The window -->\nno title", "no title");
  refused("<!-- section: Nowhere -->\n# Title\n", "\"Nowhere\"");
  const auto page = parsePage("<!-- section: The window -->\n# What\nText\n", "/pages/07-what-there-is.md");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->name, "what-there-is");
  EXPECT_EQ(page->title, "What");
  EXPECT_EQ(page->text, "Text\n");
  const auto other =
      parsePage("<!-- section: Files -->\n# What\n<!-- include: ../no-such.md -->\n", kPages + "/7-x.md");
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message.find("no-such.md"), std::string::npos) << "what it includes is not there";
  EXPECT_FALSE(makeHandbook(fullRegistry(), "/no/such/folder", {}));
}

TEST(Handbook, IsMadeInALanguage) {
  HandbookSpeech speech;
  speech.code = "xx";  // no such folder: the pages stay as they are
  speech.declared = [](const std::string& text) { return "«" + text + "»"; };
  speech.source = [](const std::string& text) { return "from " + text; };
  const auto pages = makeHandbook(fullRegistry(), kPages, kCommand, speech);
  ASSERT_TRUE(pages) << pages.error().message;
  ASSERT_EQ(pages->size(), handbook().size());
  for (std::size_t i = 0; i < pages->size(); ++i) {
    const HandbookPage &page = (*pages)[i], &english = handbook()[i];
    EXPECT_EQ(page.name, english.name);
    EXPECT_EQ(page.section, "«" + english.section + "»");
  }
  const HandbookPage* trl = pageNamed(*pages, "method-trl");
  EXPECT_TRUE(trl->title.starts_with("«"));
  EXPECT_NE(trl->text.find("«Source: from thesis"), std::string::npos) << trl->text;
  EXPECT_EQ(brokenLinks(*pages, kPictures), brokenLinks(handbook(), kPictures)) << "but one command is given here";
  EXPECT_EQ(pageNamed(*pages, "command-train")->text, pageNamed(handbook(), "command-train")->text);
}

TEST(Handbook, PagesOfALanguageStandInTheirOwnFolder) {
  const Folder folder;
  std::filesystem::create_directory(folder.file("nl"));
  const std::string first = "<!-- section: Files -->\n";
  ASSERT_TRUE(writeWhole("page", folder.file("1-one.md"), first + "# One\n"));
  ASSERT_TRUE(writeWhole("page", folder.file("2-two.md"), first + "# Two\n"));
  ASSERT_TRUE(writeWhole("page", folder.file("nl/2-two.md"), first + "# Twee\n"));
  const auto pages = writtenPages(folder.file(""), "nl");
  ASSERT_TRUE(pages) << pages.error().message;
  ASSERT_EQ(pages->size(), 2u);
  EXPECT_EQ((*pages)[0].title, "One");
  EXPECT_EQ((*pages)[1].title, "Twee");
  EXPECT_EQ((*pages)[1].name, "two");
}

TEST(Handbook, SearchingFindsTitlesFirstAndAllWords) {
  EXPECT_EQ(namesOf(pagesWith(kSmall, "tiles")), (std::vector<std::string>{"two", "one"})) << "in the title";
  EXPECT_EQ(namesOf(pagesWith(kSmall, "TILES picture")), std::vector<std::string>{"one"}) << "both words, any case";
  EXPECT_EQ(namesOf(pagesWith(kSmall, "ε-greedy")), std::vector<std::string>{"two"});
  EXPECT_EQ(namesOf(pagesWith({{"a", "Files", "A", "of Sarsa\\_2Q"}}, "sarsa_2q")), std::vector<std::string>{"a"});
  EXPECT_TRUE(pagesWith(kSmall, "tiles nowhere").empty());
  EXPECT_EQ(pagesWith(kSmall, "  ").size(), 2u) << "no word: all of them";
  const auto first = [](const std::string& words) { return pagesWith(handbook(), words).at(0)->name; };
  EXPECT_EQ(first("exit codes"), "exit-codes");
  EXPECT_EQ(first("value maps"), "panel-maps");
  EXPECT_EQ(first("policy.omega"), "parameters-policy") << "a key";
  EXPECT_EQ(first("bubblewrap"), "robot-programs");
}

TEST(Handbook, TextFromDeclarationsIsNoMarkup) {
  const Handbook pages = commandPages({{.name = "a_b", .summary = "*not* <b>bold</b> & [no](link)", .line = "1 < 2"}});
  const std::string html = htmlOf(pages.at(0));
  EXPECT_NE(html.find("*not* &lt;b&gt;bold&lt;/b&gt; &amp; [no](link)"), std::string::npos) << html;
  EXPECT_NE(html.find("1 &lt; 2"), std::string::npos) << html;
}

TEST(Handbook, LinksAreReplacedAndNothingElse) {
  std::vector<std::string> seen;
  const auto change = [&](std::string_view target, bool picture) {
    seen.push_back((picture ? "picture " : "link ") + std::string(target));
    return picture ? std::string(target) : std::string(target) + ".html";
  };
  EXPECT_EQ(withLinks("<p><a href=\"x\">a</a> <img src=\"y.png\" alt=\"\" /> <a name=\"n\"></a></p>", change),
            "<p><a href=\"x.html\">a</a> <img src=\"y.png\" alt=\"\" /> <a name=\"n\"></a></p>");
  EXPECT_EQ(seen, (std::vector<std::string>{"link x", "picture y.png"}));
}

}  // namespace surefoot
