// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot robustness`.
#include <sstream>

#include "tests/app/program.h"

namespace surefoot {

namespace {

/// Two Q-functions: one of many episodes, one of few.
struct TwoLearned : Folder {
  TwoLearned() {
    run("train --episodes 600 --save " + much());
    run("train --episodes 1 --seed 2 --save " + little());
  }
  std::string much() const { return file("much.safetensors"); }
  std::string little() const { return file("little.safetensors"); }
};

std::vector<std::string> linesIn(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

}  // namespace

TEST(RobustnessCommand, TheTableTheJsonAndTheCsvSayTheSame) {
  const TwoLearned learned;
  const std::string csv = learned.file("r.csv");
  const std::string command = "robustness " + learned.much() + " " + learned.little() +
                              " --push 0..0.2:3 --scenario 'actual;3' --set environment.pole_mass='0.9;1' --starts 40";
  const auto json = run(command + " --csv " + csv);
  ASSERT_EQ(json["models"].size(), 4u);
  ASSERT_EQ(json["cells"].size(), 2u * 4 * 3);
  const auto rows = linesIn(contentOf(csv));
  ASSERT_EQ(rows.size(), 1 + json["cells"].size());
  EXPECT_TRUE(rows[0].starts_with("file,scenario,environment.pole_mass,push,trials,falls,")) << rows[0];
  for (std::size_t i = 0; i < json["cells"].size(); ++i) {
    const auto& cell = json["cells"][i];
    EXPECT_EQ(cell["trials"], 40);
    EXPECT_LE(cell["fallen_low"], cell["fallen"]);
    EXPECT_LE(cell["fallen"], cell["fallen_high"]);
    const std::string falls = "," + std::to_string(cell["falls"].get<int>()) + ",";
    EXPECT_NE(rows[i + 1].find(",40" + falls), std::string::npos) << rows[i + 1];
  }
  const Finished table = surefoot(command);
  EXPECT_EQ(table.code, 0) << table.err;
  const auto cellOf = [&](int i) { return std::to_string(json["cells"][i]["falls"].get<int>()); };
  EXPECT_NE(table.out.find(cellOf(0) + "|" + cellOf(12)), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("3 Low damping, high friction, pole_mass = 0.9 kg"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("* the two differ"), std::string::npos) << table.out;
}

TEST(RobustnessCommand, TheNumberOfThreadsChangesNoByte) {
  const TwoLearned learned;
  const std::string command = "robustness " + learned.much() + " --push '0;0.1' --scenario all --starts 30";
  EXPECT_EQ(run(command + " --jobs 1"), run(command + " --jobs 2"));
  EXPECT_NE(run(command)["cells"], run(command + " --seed 2")["cells"]);
}

TEST(RobustnessCommand, EndedItWritesNothing) {
  const TwoLearned learned;
  const std::string csv = learned.file("r.csv"), out = learned.file("out");
  const std::string command = std::string("timeout -s INT 1 ") + SUREFOOT_PROGRAM + " robustness " + learned.much() +
                              " --push 0..0.1:9 --scenario all --starts 100000 --csv " + csv + " >" + out + " 2>&1";
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_EQ(contentOf(out), "surefoot: interrupted; nothing is written.\n");
  EXPECT_FALSE(std::filesystem::exists(csv));
}

TEST(RobustnessCommand, RefusesWhatCannotBeBeforeItLives) {
  const TwoLearned learned;
  const std::string command = "robustness " + learned.much() + " ";
  expectRefusal("robustness", 2, {"FILE"});
  expectRefusal("robustness nowhere.safetensors", 3, {"nowhere.safetensors"});
  expectRefusal(command + "nowhere.safetensors", 3, {"nowhere.safetensors"});
  expectRefusal(command + learned.little() + " third", 2, {"third"});
  expectRefusal(command + "--push 0..2", 2, {"--push", "0..2:9"});
  expectRefusal(command + "--push nan", 2, {"--push", "nan"});
  expectRefusal(command + "--push-at -1..2", 2, {"--push-at", "600"});
  expectRefusal(command + "--seconds 1e9", 2, {"--seconds", "3600"});
  expectRefusal(command + "--scenario 9", 2, {"9"});
  expectRefusal(command + "--set environment.friction=-7", 2, {"environment.friction", "-7"});
  expectRefusal(command + "--starts 0", 2, {"--starts", "0"});
  expectRefusal(command + "--jobs 0", 2, {"--jobs"});
  expectRefusal(command + "--push 0..1:1000 --set environment.friction=0..0.1:1000", 2, {"1,000,000 cells", "100,000"});
  const std::string cliff = learned.file("cliff.safetensors");
  run("train --environment cliff --features table --episodes 5 --save " + cliff);
  expectRefusal(command + cliff, 2, {"pendulum", "cliff"});
  expectRefusal("robustness " + cliff + " --push 0.1", 2, {"no body to push"});
  expectRefusal("robustness " + cliff + " --seconds 3", 2, {"no clock"});
  const std::string there = learned.file("there.csv");
  std::ofstream(there) << "mine";
  expectRefusal(command + "--csv " + there, 3, {"there.csv"});
  EXPECT_EQ(contentOf(there), "mine");
}

}  // namespace surefoot
