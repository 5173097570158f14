// SPDX-License-Identifier: GPL-3.0-or-later
// The manual: a page for every command, with everything that its help names; and versions.
#include <regex>
#include <set>
#include <sstream>

#include "app/process/exit_code.h"
#include "tests/app/program.h"

namespace surefoot {

namespace {

std::vector<std::string> commandsOfHelp() {
  std::istringstream help(surefoot("--help").out);
  std::vector<std::string> commands;
  bool inside = false;
  for (std::string line; std::getline(help, line);) {
    if (line == "Subcommands:") {
      inside = true;
      continue;
    }
    if (inside && line.empty()) break;
    if (inside) commands.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return commands;
}

/// A page without marks of the formatter and in one line.
std::string plainPage(const std::string& file) {
  std::string text = std::regex_replace(contentOf(file), std::regex(R"(\\f[BIR]|\\&)"), "");
  text = std::regex_replace(text, std::regex(R"(\\-)"), "-");
  return std::regex_replace(text, std::regex(R"(\s+)"), " ");
}

}  // namespace

TEST(Manual, HasAPageForEveryCommandWithAllThatItsHelpNames) {
  const Folder folder;
  ASSERT_EQ(surefoot("manual " + folder.file("man") + " 2026-11-30").code, 0);
  const auto commands = commandsOfHelp();
  ASSERT_GT(commands.size(), 20u);
  const std::string all = plainPage(folder.file("man/surefoot.1"));
  for (const std::string& command : commands) {
    const std::string page = plainPage(folder.file("man/surefoot-" + command + ".1"));
    EXPECT_NE(all.find("surefoot-" + command + "(1)"), std::string::npos) << command;
    for (const char* heading : {".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH OPTIONS", ".SH EXAMPLES",
                                ".SH EXIT STATUS", ".SH SEE ALSO"})
      EXPECT_NE(page.find(heading), std::string::npos) << command << " " << heading;
    const std::string help = surefoot(command + " --help").out;
    const std::regex option(R"(--[a-z0-9-]+)");
    for (auto o = std::sregex_iterator(help.begin(), help.end(), option); o != std::sregex_iterator(); ++o)
      EXPECT_NE(page.find(o->str()), std::string::npos) << command << " " << o->str();
  }
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder.file("man"))) ++files;
  EXPECT_EQ(files, commands.size() + 2);
}

TEST(Manual, OfParametersHasEveryNameAndKey) {
  const Folder folder;
  ASSERT_EQ(surefoot("manual " + folder.file("man") + " 2026-11-30").code, 0);
  const std::string page = plainPage(folder.file("man/surefoot-parameters.7"));
  const auto list = nlohmann::json::parse(surefoot("list --json").out);
  for (const auto& [kind, entries] : list.items())
    for (const auto& entry : entries) {
      const std::string name = entry["name"];
      EXPECT_NE(page.find(".TP " + name), std::string::npos) << kind << " " << name;
    }
}

TEST(Manual, EveryExampleUsesWhatItsCommandTakes) {
  for (const std::string& command : commandsOfHelp()) {
    const std::string help = surefoot(command + " --help").out;
    const auto examples = help.find("Examples:\n");
    ASSERT_NE(examples, std::string::npos) << command;
    const std::string options = help.substr(0, examples), shown = help.substr(examples);
    const std::regex option(R"( (--[a-z0-9-]+))");
    for (auto o = std::sregex_iterator(shown.begin(), shown.end(), option); o != std::sregex_iterator(); ++o)
      EXPECT_NE(options.find((*o)[1].str()), std::string::npos) << command << " " << (*o)[1];
    EXPECT_NE(shown.find("  surefoot " + command), std::string::npos);
  }
}

// The formatter of OpenBSD reads every page without a remark, where it is installed.
TEST(Manual, IsCleanForMandoc) {
  if (std::system("command -v mandoc >/dev/null") != 0) GTEST_SKIP() << "mandoc is not installed";
  const Folder folder;
  ASSERT_EQ(surefoot("manual " + folder.file("man") + " 2026-11-30").code, 0);
  const std::string command = "cd " + folder.file("man") + " && mandoc -Tlint -Wstyle * >../said 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(contentOf(folder.file("said")), "");
}

TEST(Manual, NeedsAFolderAndADate) {
  expectRefusal("manual", 2, {"folder", "date"});
  const Folder folder;
  std::ofstream(folder.file("out")) << "a file";
  expectRefusal("manual " + folder.file("out") + "/a 2026-11-30", 3, {"out", "cannot be made"});
}

TEST(Manual, TheExitCodesOfTheHandbookAreThoseOfTheProgram) {
  const std::string page = contentOf(SUREFOOT_SOURCE "/resources/handbook/67-exit-codes.md");
  const std::string table = std::regex_replace(page, std::regex("`"), "");
  const std::string help = surefoot("--help").out;
  for (const ExitMeaning& m : kExitMeanings) {
    const std::string text(m.text);
    EXPECT_NE(table.find("| " + std::to_string(m.code) + " | " + text + " |"), std::string::npos) << m.code;
    EXPECT_NE(help.find(text), std::string::npos) << m.code;
  }
}

TEST(Versions, OfAllLibrariesAsJson) {
  for (const char* before : {"", "train ", "list "}) {
    const Finished run = surefoot(std::string(before) + "--version --json");
    ASSERT_EQ(run.code, 0) << before << run.err;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ("surefoot " + json["surefoot"].get<std::string>() + "\n", surefoot("--version").out);
    EXPECT_TRUE(json["lives"].is_number());
    const std::regex number(R"(\d+(\.\d+)+[a-z0-9.-]*)");
    for (const char* library : {"Box2D", "Eigen", "SQLite", "SQLiteCpp", "NLopt", "{fmt}", "nlohmann/json", "toml++",
                                "CLI11", "Boost", "zlib"})
      EXPECT_TRUE(std::regex_match(json["libraries"].at(library).get<std::string>(), number)) << library;
  }
  expectRefusal("--json", 2, {"--version"});
  expectRefusal("--json list", 2, {"--version"});
}

}  // namespace surefoot
