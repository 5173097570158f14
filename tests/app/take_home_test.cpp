// SPDX-License-Identifier: GPL-3.0-or-later
// What a robot engineer takes home: roll-outs for NumPy, policies in C.
#include <cmath>
#include <sstream>

#include "tests/app/program.h"

namespace surefoot {

namespace {

/// A folder with the Q-function of a short life.
struct Learned : Folder {
  explicit Learned(const std::string& arguments = "--episodes 200") {
    run("train " + arguments + " --save " + file("q.safetensors"));
  }
  std::string q() const { return file("q.safetensors"); }
};

}  // namespace

TEST(RolloutCommand, NumPyReadsWhatTheTableHasAndJsonNames) {
  const Learned learned;
  const std::string csv = learned.file("r.csv"), npz = learned.file("r.npz"), script = learned.file("read.py");
  const auto json = run("rollout " + learned.q() + " --seconds 3 --push 1:0.05 --csv " + csv + " --npz " + npz);
  EXPECT_EQ(json["steps"], 600);
  EXPECT_EQ(json["seconds"], 3.0);
  std::string keys;
  for (const auto& signal : json["signals"]) {
    keys += (keys.empty() ? "" : ",") + signal["key"].get<std::string>();
    EXPECT_FALSE(signal["title"].get<std::string>().empty());
  }
  EXPECT_TRUE(contentOf(csv).starts_with(keys + "\n"));
  std::ofstream(script) << R"(
import sys, csv, numpy
arrays = numpy.load(sys.argv[2])
rows = list(csv.DictReader(open(sys.argv[1])))
assert list(rows[0]) == list(arrays.files), arrays.files
for key in arrays.files:
    column = numpy.array([float(r[key]) if r[key] else numpy.nan for r in rows])
    assert column.dtype == arrays[key].dtype and numpy.array_equal(column, arrays[key], equal_nan=True), key
print(len(rows), arrays["reward"].sum())
)";
  const std::string out = learned.file("out");
  ASSERT_EQ(std::system(("/usr/bin/python3 " + script + " " + csv + " " + npz + " >" + out).c_str()), 0);
  double rows = 0, reward = 0;
  std::istringstream(contentOf(out)) >> rows >> reward;
  EXPECT_EQ(rows, 600);
  EXPECT_NEAR(reward, json["reward"].get<double>(), 1e-9);
}

TEST(RolloutCommand, GivesTheSameBytesTwice) {
  const Learned learned;
  for (const char* name : {"a.npz", "b.npz"})
    run("rollout " + learned.q() + " --seconds 1 --npz " + learned.file(name));
  EXPECT_EQ(contentOf(learned.file("a.npz")), contentOf(learned.file("b.npz")));
  EXPECT_NE(run("rollout " + learned.q() + " --seconds 1 --seed 2")["hash"],
            run("rollout " + learned.q() + " --seconds 1")["hash"]);
}

TEST(RolloutCommand, RefusesWhatCannotBeBeforeItLives) {
  const Learned learned;
  const std::string rollout = "rollout " + learned.q() + " ";
  EXPECT_TRUE(run(rollout + "--seconds 1")["strides"].is_null()) << "a pendulum has no feet";
  expectRefusal("rollout", 2, {"FILE"});
  expectRefusal("rollout nowhere.safetensors", 3, {"nowhere.safetensors"});
  expectRefusal(rollout + "--seconds -1", 2, {"--seconds", "-1"});
  expectRefusal(rollout + "--seconds 1e9", 2, {"--seconds", "3600"});
  expectRefusal(rollout + "--push 1", 2, {"--push", "T:IMPULSE"});
  expectRefusal(rollout + "--push -1:0.3", 2, {"--push", "-1:0.3"});
  expectRefusal(rollout + "--push 1:nan", 2, {"--push"});
  expectRefusal(rollout + "--state '1;2'", 2, {"--state", "3"});
  expectRefusal(rollout + "--state '9;0;0'", 2, {"pole"});
  expectRefusal(rollout + "--policy softmacks", 2, {"softmax"});
  expectRefusal(rollout + "--set agent.discount=0.5", 2, {"agent.discount", "nothing is learned"});
  expectRefusal(rollout + "--scenario 9", 2, {"9"});
  const std::string csv = learned.file("there.csv");
  std::ofstream(csv) << "mine";
  expectRefusal(rollout + "--csv " + csv, 3, {"there.csv"});
  EXPECT_EQ(contentOf(csv), "mine");
}

TEST(ExportCommand, WritesAPolicyThatChecksItself) {
  const Learned learned("--episodes 100 --set features.memory=8192");
  const std::string c = learned.file("policy.c"), program = learned.file("policy");
  const Finished written = surefoot("export " + learned.q() + " --c " + c + " --self-test");
  EXPECT_EQ(written.code, 0) << written.err;
  EXPECT_NE(written.err.find("tables of "), std::string::npos) << "its size is told";
  const std::string text = contentOf(c);
  for (const char* words : {"state[0]: pole angle in rad, from -1.41372", "Actions (torque, in N m)", "3: 0.75",
                            "Learned on pendulum thesis actual by sarsa", "after "})
    EXPECT_NE(text.find(words), std::string::npos) << words;
  ASSERT_EQ(
      std::system(("gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -DPOLICY_SELF_TEST -o " + program + " " + c).c_str()),
      0);
  EXPECT_EQ(std::system((program + " >/dev/null").c_str()), 0);
}

TEST(ExportCommand, RefusesWhatDoesNotGoTogether) {
  const Learned learned;
  expectRefusal("export", 2, {"FILE"});
  expectRefusal("export " + learned.q(), 2, {"--csv", "--c"});
  expectRefusal("export " + learned.q() + " --float --csv x", 2, {"--float", "--c"});
  expectRefusal("export " + learned.q() + " --csv x --c y", 2, {"--c"});
  const std::string there = learned.file("there.c");
  std::ofstream(there) << "mine";
  expectRefusal("export " + learned.q() + " --c " + there, 3, {"there.c"});
  EXPECT_EQ(contentOf(there), "mine");
}

}  // namespace surefoot
