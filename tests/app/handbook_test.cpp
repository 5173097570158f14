// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook as web pages: all of it is there, every link leads somewhere, and README leads to it.
#include <algorithm>
#include <set>
#include <sstream>

#include "app/process/exit_code.h"
#include "tests/app/program.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

/// The web pages, written once.
const std::string& pages() {
  static const Folder folder;
  static const std::string path = [] {
    const Finished written = surefoot("handbook " + folder.file("pages"));
    EXPECT_EQ(written.code, 0) << written.err;
    return folder.file("pages");
  }();
  return path;
}

std::string page(const std::string& name) {
  return contentOf(pages() + "/" + name + ".html");
}

/// What stands between `begin` and `end`, again and again.
std::vector<std::string> between(const std::string& text, const std::string& begin, const std::string& end) {
  std::vector<std::string> all;
  for (auto at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    all.push_back(text.substr(at, text.find(end, at) - at));
  }
  return all;
}

std::vector<std::string> files(const std::string& extension) {
  std::vector<std::string> all;
  for (const auto& entry : std::filesystem::directory_iterator(pages()))
    if (entry.path().extension() == extension) all.push_back(entry.path().string());
  return all;
}

}  // namespace

TEST(HandbookPages, EveryCommandHasOneWithItsOptions) {
  const Finished help = surefoot("--help");
  std::istringstream lines(help.out.substr(help.out.find("Subcommands:")));
  std::string line;
  int commands = 0;
  for (std::getline(lines, line); std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] == ' ') continue;  // the rest of an explanation
    const std::string name = line.substr(2, line.find(' ', 2) - 2);
    const std::string text = page("command-" + name);
    EXPECT_NE(text.find("surefoot " + name), std::string::npos) << name;
    const std::string own = surefoot(name + " --help").out;
    for (const std::string& option : between(own, "  --", " "))
      EXPECT_NE(text.find("--" + option.substr(0, option.find('\n'))), std::string::npos) << name << " --" << option;
    EXPECT_NE(page("index").find("command-" + name + ".html"), std::string::npos) << name;
    ++commands;
  }
  EXPECT_GT(commands, 20);
  EXPECT_NE(page("command-train").find("--allow-programs"), std::string::npos);
}

TEST(HandbookPages, EveryParameterHasAPlace) {
  std::string all;
  for (const std::string& file : files(".html"))
    if (file.find("/parameters-") != std::string::npos || file.find("/world-") != std::string::npos)
      all += contentOf(file);
  const Json list = run("list");
  std::set<std::string> missing;
  for (const Json& parameter : list["parameters"])
    if (all.find("<a name=\"" + parameter["name"].get<std::string>() + "\">") == std::string::npos)
      missing.insert(parameter["name"]);
  EXPECT_TRUE(missing.empty()) << missing.size() << ", such as " << *missing.begin();
  EXPECT_GT(list["parameters"].size(), 500u);
}

TEST(HandbookPages, EveryLinkAndPictureIsThere) {
  int links = 0;
  for (const std::string& file : files(".html")) {
    const std::string text = contentOf(file);
    std::vector<std::string> targets = between(text, "href=\"", "\"");
    for (const std::string& picture : between(text, "src=\"", "\"")) targets.push_back(picture);
    for (const std::string& target : targets) {
      if (target.starts_with("https://")) continue;
      ++links;
      const auto hash = std::min(target.find('#'), target.size());
      const std::string to = hash == 0 ? file : pages() + "/" + target.substr(0, hash);
      ASSERT_TRUE(std::filesystem::is_regular_file(to)) << file << " leads to " << target;
      const std::string anchor = hash < target.size() ? "<a name=\"" + target.substr(hash + 1) + "\">" : "";
      EXPECT_NE(contentOf(to).find(anchor), std::string::npos) << file << " leads to " << target;
    }
  }
  EXPECT_GT(links, 1000);
}

TEST(HandbookPages, AreWellFormed) {
  std::string command =
      "/usr/bin/python3 -c 'import sys, xml.etree.ElementTree as e\nfor f in sys.argv[1:]: e.parse(f)'";
  for (const std::string& file : files(".html")) command += " " + file;
  const Finished parsed = finish(command);
  EXPECT_EQ(parsed.code, 0) << parsed.err;
}

TEST(HandbookPages, AFolderThatIsThereIsNotTouched) {
  const Folder folder;
  std::filesystem::create_directory(folder.file("mine"));
  expectRefusal("handbook " + folder.file("mine"), kFile, {"mine", "exists already"});
  EXPECT_TRUE(std::filesystem::is_empty(folder.file("mine")));
  expectRefusal("handbook", kUsage, {"FOLDER"});
  expectRefusal("handbook /proc/no/such", kFile, {"/proc/no/such"});
}

TEST(HandbookPages, ExitCodesAreThoseOfTheProgram) {
  const std::string text = page("exit-codes");
  for (const int code : {kDone, kDifferent, kUsage, kFile, kDiverged, kMismatch, kUnanswered, kInterrupted})
    EXPECT_NE(text.find(">" + std::to_string(code) + "</td>"), std::string::npos) << code;
}

/// What README told of before it led to the handbook, and the page that tells of it now.
TEST(HandbookPages, WhatReadmeToldHasAPage) {
  std::istringstream names(
      "first-steps window page-experiment keys saving films-and-exports follow taking-lessons teaching "
      "writing-lessons page-robot robots robot-programs robot-format command-line caution rewinds walkers "
      "numbers files q-functions q-function-python results exit-codes from-c from-python plans recipes "
      "statistics shards stores same-bits speed pendulum-constants building troubleshooting security compare "
      "pre-learning robustness what-if page-lessons policy-as-c checkpoints-and-journals");
  for (std::string name; names >> name;) EXPECT_GT(page(name).size(), 500u) << name;
}

TEST(Readme, IsShortAndItsLinksLeadToFiles) {
  const std::string readme = contentOf(SUREFOOT_SOURCE "/README.md");
  EXPECT_LT(std::count(readme.begin(), readme.end(), '\n'), 200);
  int links = 0;
  for (const std::string& target : between(readme, "](", ")")) {
    if (target.starts_with("https://")) continue;
    EXPECT_TRUE(std::filesystem::exists(SUREFOOT_SOURCE "/" + target)) << target;
    ++links;
  }
  EXPECT_GT(links, 20);
}

}  // namespace surefoot
