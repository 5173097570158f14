// SPDX-License-Identifier: GPL-3.0-or-later
// `--load FILE`: the file knows what it was learned under, and commands that are suggested run as they are.
#include <sstream>

#include "core/text/shell_text.h"
#include "tests/app/program.h"

namespace surefoot {

using Json = nlohmann::json;

TEST(Load, TheFileAloneIsEnough) {
  const Folder folder;
  const std::string q = folder.file("q");
  run("train --environment leo --preset mismatched --agent sarsa-2q --policy softmax --set policy.temperature=2 "
      "--minutes 0.2 --save " +
      q);
  const Json c = run("train --minutes 0.1 --load " + q)["configuration"];
  for (const auto& [key, value] : {std::pair{"environment", "leo"}, std::pair{"preset", "mismatched"},
                                   std::pair{"agent", "sarsa-2q"}, std::pair{"policy", "softmax"}})
    EXPECT_EQ(c[key], value);
  EXPECT_EQ(c["parameters"]["policy.temperature"], 2.0);
  EXPECT_EQ(c["minutes"], 0.1);
  EXPECT_TRUE(c["until"].is_null());
}

TEST(Load, WhatIsGivenComesOnTop) {
  const Folder folder;
  const std::string q = folder.file("q");
  run("train --scenario 2 --set environment.goal_reward=300 --set agent.step_size=0.3 --minutes 0.5 --save " + q);
  const Json c =
      run("train --minutes 0.1 --scenario actual --policy trl --set policy.threshold=20 --load " + q)["configuration"];
  EXPECT_EQ(c["scenario"], "actual");
  EXPECT_EQ(c["policy"], "trl");
  EXPECT_EQ(c["parameters"]["environment.damping"], 0.08) << "the scenario's own";
  EXPECT_EQ(c["parameters"]["environment.goal_reward"], 300) << "that the file's life had changed";
  EXPECT_EQ(c["parameters"]["agent.step_size"], 0.3);
  EXPECT_EQ(c["parameters"]["policy.threshold"], 20);
  EXPECT_EQ(run("train --minutes 0.1 --load " + q)["configuration"]["parameters"]["environment.damping"], 0.04);
}

TEST(Load, AContradictionIsRefusedWithBothValues) {
  const Folder folder;
  const std::string q = folder.file("q");
  run("train --environment cliff --episodes 9 --save " + q);
  expectRefusal("train --episodes 9 --environment pendulum --load " + q, 3, {"cliff", "pendulum"});
  expectRefusal("train --episodes 9 --features table --load " + q, 3, {"tile-coder", "table"});
  expectRefusal("train --episodes 9 --agent sarsa-2q --load " + q, 3, {"positive", "q"});
  expectRefusal("train --episodes 9 --set features.tilings=8 --load " + q, 3, {"tilings", "16", "8"});
  expectRefusal("train --episodes 9 --scenario 2 --load " + q, 2, {"scenario", "pendulum", "cliff"});
  EXPECT_EQ(run("train --episodes 9 --agent q-learning --environment cliff --load " + q)["configuration"]["agent"],
            "q-learning")
      << "a table that fits";
}

TEST(Load, ANameIsOneWordOfAShell) {
  const Folder folder;
  for (const char* name : {"plain.safetensors", "with blank", "it's", "a\"b", "Läufer $HOME", "a;b&c", "*?[x]", "~x"}) {
    EXPECT_EQ(std::system(("printf %s " + shellQuoted(name) + " >" + folder.file("out")).c_str()), 0);
    EXPECT_EQ(contentOf(folder.file("out")), name);
  }
  EXPECT_EQ(shellQuoted("/tmp/Läufer-1.safetensors"), "/tmp/Läufer-1.safetensors") << "no quotes without need";
}

namespace {

/// The commands in the shell blocks of a page of the handbook.
std::vector<std::string> commandsOf(const std::string& page) {
  std::istringstream in(contentOf(SUREFOOT_SOURCE "/resources/handbook/" + page));
  std::vector<std::string> commands;
  bool shell = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("```")) shell = line == "```sh";
    if (shell && line.starts_with("surefoot ")) commands.push_back(line.substr(9));
  }
  return commands;
}

/// As it is written, but shorter: no life of the handbook is worth a minute of testing.
std::string shorter(std::string command) {
  for (const char* option : {"--minutes ", "--every "}) {
    const auto at = command.find(option);
    if (at == std::string::npos) continue;
    const auto digits = at + std::string(option).size();
    command.replace(digits, command.find_first_not_of("0123456789", digits) - digits, "3");
  }
  const auto optional = command.find('[');  // what may be left away
  if (optional != std::string::npos) command.resize(optional);
  return command;
}

}  // namespace

TEST(Load, TheHandbooksCommandsOnFilesRunOneAfterTheOther) {
  const Folder folder;
  const auto commands = commandsOf("70-files.md");
  ASSERT_GT(commands.size(), 10u);
  for (const std::string& command : commands) {
    const std::string whole = "cd " + folder.file("") + " && " SUREFOOT_PROGRAM " " + shorter(command) + " >out 2>err";
    EXPECT_EQ(std::system(whole.c_str()), 0) << command << "\n" << contentOf(folder.file("err"));
  }
}

}  // namespace surefoot
