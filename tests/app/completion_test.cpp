// SPDX-License-Identifier: GPL-3.0-or-later
// What the program offers to a shell, and what Bash makes of it.
#include <set>
#include <sstream>

#include "tests/app/program.h"

namespace surefoot {

namespace {

/// What may stand at the end of the line; directives for the shell begin with ":".
std::set<std::string> offered(const std::string& words) {
  const Finished run = surefoot("complete " + words);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  std::set<std::string> all;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) all.insert(line.substr(0, line.find('\t')));
  return all;
}

void expectOffered(const std::string& words, const std::vector<std::string>& some,
                   const std::vector<std::string>& none = {}) {
  const auto all = offered(words);
  for (const std::string& word : some) EXPECT_TRUE(all.contains(word)) << words << ": " << word;
  for (const std::string& word : none) EXPECT_FALSE(all.contains(word)) << words << ": " << word;
}

/// The words that Bash would show for a line, of which `words` is how it takes it apart.
std::string inBash(const std::string& folder, const std::string& words) {
  std::ofstream(folder + "/run.sh") << "PATH=" << std::filesystem::path(SUREFOOT_PROGRAM).parent_path().string()
                                    << ":$PATH\ncd " << folder << "\nsource " << SUREFOOT_SOURCE
                                    << "/resources/completions/surefoot.bash\nCOMP_WORDS=(" << words
                                    << ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_surefoot\n"
                                    << "IFS=' '; echo \"${COMPREPLY[*]}\"\n";
  EXPECT_EQ(std::system(("bash " + folder + "/run.sh >" + folder + "/said 2>" + folder + "/err").c_str()), 0);
  EXPECT_EQ(contentOf(folder + "/err"), "");
  const std::string said = contentOf(folder + "/said");
  return said.substr(0, said.find('\n'));
}

}  // namespace

TEST(Completion, OffersCommandsOptionsAndNames) {
  expectOffered("tr", {"train"}, {"window", "manual", "complete"});
  expectOffered("''", {"train", "statistics", ":files toml surefoot safetensors jsonl sqlite"}, {"--help", "manual"});
  expectOffered("--", {"--help", "--version", "--json"});
  expectOffered("train --", {"--environment", "--set", "--seed", "--help"}, {"--turbo"});
  expectOffered("train --seed 3 --set a=1 --", {"--set", "--lives"}, {"--seed"});
  expectOffered("train --environment ''", {"pendulum", "leo", "cliff", "hopper", ":files toml"});
  expectOffered("train --environment=pen", {"--environment=pendulum"}, {"--environment=leo"});
  expectOffered("train --policy s", {"softmax"}, {"trl"});
  expectOffered("train --preset ''", {"thesis", "lab"});
  expectOffered("train --scenario ''", {"actual", "1", "6"});
  expectOffered("train --environment cliff --scenario ''", {}, {"1"});
  expectOffered("window --page l", {"live", "lessons"}, {"robot"});
  expectOffered("window --language ''", {"en", "nl", "de"});
  expectOffered("window --lesson ''", {"the-cliff"});
  expectOffered("new roller --like ''", {"segway"}, {"pendulum"});
  expectOffered("reproduce 4.", {"4.10", "4.4-4.9"}, {"all", "5.1"});
  expectOffered("experiment ''", {"quick", ":files toml"});
  expectOffered("statistics ''", {":files sqlite"});
  expectOffered("rollout q.safetensors --film ''", {":files webp"});
  expectOffered("export results.sqlite --csv ''", {":folders"});
  expectOffered("nothing ''", {}, {"train"});
}

TEST(Completion, OffersKeysOfWhatWasChosenAndTheValuesOfChoices) {
  expectOffered("train --set policy.", {"policy.epsilon=", "policy.temperature="}, {"agent.discount="});
  expectOffered("train --set agent.trace=", {"agent.trace=replacing", "agent.trace=accumulating"}, {"agent.trace="});
  expectOffered("train --set=agent.trace=r", {"--set=agent.trace=replacing"});
  expectOffered("train --set environment.", {"environment.damping="});
  expectOffered("train --environment cliff --set environment.", {}, {"environment.damping="});
  expectOffered("train --environment hopper --set ''", {"policy.epsilon="}, {"environment.damping="});
  expectOffered("train --set policy.epsilon=", {}, {"policy.epsilon="});
  expectOffered("train --at 300:p", {"300:policy.epsilon=", "300:push=", "300:policy="});
  expectOffered("train --at 300:policy=s", {"300:policy=softmax"});
}

// Every value that a person chooses among is offered: a new option needs a line in completion_values.cpp.
TEST(Completion, KnowsTheValuesOfEveryNameAndFile) {
  std::istringstream help(surefoot("--help").out);
  bool inside = false;
  for (std::string line; std::getline(help, line);) {
    if (line == "Subcommands:") {
      inside = true;
      continue;
    }
    if (!inside || line.empty()) inside = false;
    if (!inside) continue;
    const std::string command = line.substr(2, line.find(' ', 2) - 2);
    std::istringstream options(surefoot(command + " --help").out);
    for (std::string option; std::getline(options, option);) {
      std::istringstream words(option);
      std::string name, type;
      words >> name >> type;
      type = type.substr(0, type.find('='));
      if (!name.starts_with("--") || (type != "NAME" && type != "ROBOT" && !type.starts_with("FILE"))) continue;
      if (name == "--student") continue;  // a name of one's own
      EXPECT_FALSE(offered(command + " " + name + " ''").empty()) << command << " " << name;
    }
  }
}

TEST(Completion, WorksInBash) {
  const Folder folder;
  const std::string here = std::filesystem::path(folder.file("x")).parent_path().string();
  std::ofstream(here + "/my robot.toml") << "";
  std::ofstream(here + "/notes.txt") << "";
  EXPECT_EQ(inBash(here, "surefoot trai"), "train");
  EXPECT_EQ(inBash(here, "surefoot train --polic"), "--policy");
  EXPECT_EQ(inBash(here, "surefoot train --policy soft"), "softmax");
  // Bash takes a word apart at = and : and replaces only what is behind them.
  EXPECT_EQ(inBash(here, "surefoot train --set policy.temperature_e"), "policy.temperature_end=");
  EXPECT_EQ(inBash(here, "surefoot train --set agent.trace = acc"), "accumulating");
  EXPECT_EQ(inBash(here, "surefoot train --set agent.trace ="), "replacing accumulating");
  EXPECT_EQ(inBash(here, "surefoot train --at 300 : policy = soft"), "softmax");
  EXPECT_EQ(inBash(here, "surefoot check m"), "my robot.toml");
  EXPECT_EQ(inBash(here, R"(surefoot check 'my\ ')"), "my robot.toml");
  EXPECT_EQ(inBash(here, "surefoot statistics ''"), "");
}

TEST(Completion, TheScriptsAreWellFormed) {
  const std::string scripts = SUREFOOT_SOURCE "/resources/completions/";
  const std::pair<const char*, std::string> shells[] = {{"bash", "bash -n " + scripts + "surefoot.bash"},
                                                        {"zsh", "zsh -n " + scripts + "_surefoot"},
                                                        {"fish", "fish --no-execute " + scripts + "surefoot.fish"}};
  for (const auto& [shell, check] : shells) {
    if (std::system(("command -v " + std::string(shell) + " >/dev/null").c_str()) != 0) continue;
    EXPECT_EQ(std::system(check.c_str()), 0) << shell;
  }
}

}  // namespace surefoot
