// SPDX-License-Identifier: GPL-3.0-or-later
// Q-functions as a user meets them: saved, loaded, asked, carried over.
#include <sys/stat.h>

#include <cmath>
#include <sstream>

#include "core/basics/random.h"
#include "tests/app/program.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

/// The Python of the handbook.
std::string example() {
  const std::string page = contentOf(SUREFOOT_SOURCE "/resources/handbook/72-q-function-python.md");
  const std::string fence = "```python\n";
  const auto begin = page.find(fence) + fence.size();
  return page.substr(begin, page.find("```", begin) - begin);
}

/// States within the ranges of the variables: some anywhere, some where an episode begins, which are more familiar.
std::vector<std::string> statesOf(const Json& about, int count) {
  Random random(5);
  std::vector<std::string> states;
  for (int i = 0; i < count; ++i) {
    std::ostringstream state;
    for (const Json& v : about["state"]) {
      const double near = i % 2 == 0 ? 1.0 : 0.05;
      state << (state.str().empty() ? "" : ";")
            << random.uniform(near * v["low"].get<double>(), near * v["high"].get<double>());
    }
    states.push_back(state.str());
  }
  return states;
}

/// A Q-function of `train ARGUMENTS`, read by the handbook's Python: in so many states, the values of every action and
/// what these do are those of `query`.
void expectThatPythonReads(const std::string& arguments) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors"), script = folder.file("example.py"), out = folder.file("out");
  run("train " + arguments + " --save " + q);
  std::ofstream(script) << example() << R"(
import sys
about, tensors = load(sys.argv[1])
for text in sys.argv[2:]:
    print(json.dumps({"q": list(action_values(about, tensors, [float(x) for x in text.split(";")])),
                      "actions": actions(about).tolist()}))
)";
  const auto states = statesOf(run("inspect " + q)["about"], 8);
  std::string command = "/usr/bin/python3 " + script + " " + q;
  for (const std::string& state : states) command += " '" + state + "'";
  ASSERT_EQ(std::system((command + " >" + out).c_str()), 0) << "python3-numpy is needed";
  std::istringstream lines(contentOf(out));
  for (const std::string& state : states) {
    std::string line;
    ASSERT_TRUE(std::getline(lines, line));
    const Json theirs = Json::parse(line), ours = run("query " + q + " --state '" + state + "'");
    ASSERT_EQ(theirs["q"].size(), ours["q"].size());
    for (std::size_t a = 0; a < ours["q"].size(); ++a)
      EXPECT_NEAR(theirs["q"][a].get<double>(), ours["q"][a].get<double>(), 1e-12) << arguments << " at " << state;
    EXPECT_EQ(theirs["actions"], ours["action_coordinates"]) << arguments;
  }
}

}  // namespace

TEST(Files, TheHandbooksPythonReadsDenseTables) {
  expectThatPythonReads("--minutes 1");
  expectThatPythonReads("--minutes 1 --agent sarsa-2q --set negative.scale=0.5 --set positive.pole_angle_to=0.5");
  expectThatPythonReads("--minutes 0.5 --features radial-basis");
  expectThatPythonReads("--environment cliff --features table --episodes 30");
}

TEST(Files, TheHandbooksPythonReadsHashedTables) {
  expectThatPythonReads("--minutes 1 --set features.memory=100000");
  expectThatPythonReads("--minutes 1 --set features.memory=2000");  // too few: some look-ups fail
  expectThatPythonReads("--minutes 0.5 --agent sarsa-2q --set positive.memory=3000");
  expectThatPythonReads("--environment leo --minutes 2");
}

// Not the numbers of the combinations: what each joint gets.
TEST(Files, QuerySpeaksInPhysicalUnits) {
  const Folder folder;
  const std::string leo = folder.file("leo"), pendulum = folder.file("pendulum"), cliff = folder.file("cliff");
  run("train --environment leo --minutes 0.2 --save " + leo);
  const Json json = run("query " + leo + " --state 0,0,0,0,0,0,0,0,0,0");
  ASSERT_EQ(json["actions"].size(), 343u);
  EXPECT_EQ(json["action_variables"][1]["variable"], "swing_hip_voltage");
  EXPECT_EQ(json["action_variables"][1]["unit"], "V");
  const double most = json["action_coordinates"][342][0];
  EXPECT_GT(most, 5.0);
  EXPECT_EQ(json["action_coordinates"][0], Json({-most, -most, -most}));
  EXPECT_EQ(json["action_coordinates"][1][1], -most) << "the last voltage counts fastest";
  EXPECT_NE(json["actions"][342].get<std::string>().find(" V"), std::string::npos);
  const std::string table = surefoot("query " + leo + " --state 0,0,0,0,0,0,0,0,0,0").out;
  EXPECT_NE(table.find("swing knee voltage [V]"), std::string::npos) << table.substr(0, 300);
  EXPECT_EQ(table.find(" 342 "), std::string::npos);
  expectRefusal("query " + leo, 2, {"--state", "swing_knee_rate", "0,0,0,0,0,0,0,0,0,0"});

  run("train --minutes 0.2 --save " + pendulum);
  EXPECT_EQ(run("query " + pendulum + " --state 0,0,0")["actions"][3], "0.75 N m");
  EXPECT_NE(surefoot("query " + pendulum + " --state 0,0,0").out.find("torque [N m]"), std::string::npos);
  run("train --environment cliff --episodes 9 --save " + cliff);
  EXPECT_EQ(run("query " + cliff + " --state 0,0")["actions"][0].get<std::string>().find(' '), std::string::npos);
}

TEST(Files, QueryTellsTheParts) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors");
  run("train --minutes 0.5 --agent sarsa-2q --set negative.scale=0.5 --policy trl --save " + q);
  const Json json = run("query " + q + " --state 0.1,0,0");
  double sum = 0.0;
  for (std::size_t a = 0; a < 5; ++a) {
    EXPECT_NEAR(json["q"][a].get<double>(), json["q_positive"][a].get<double>() + json["q_negative"][a].get<double>(),
                1e-12);
    sum += json["probabilities"][a].get<double>();
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
  EXPECT_EQ(json["policy"], "trl");
  EXPECT_EQ(run("query " + q + " --state 0.1,0,0 --policy softmax --set policy.temperature=1e6")["probabilities"][0],
            run("query " + q + " --state 0.1,0,0 --policy softmax --set policy.temperature=1e6")["probabilities"][0]);
  expectRefusal("query " + q, 2, {"--state"});
  expectRefusal("query " + q + " --state 1,2", 2, {"--state", "2 values", "pole_angle"});
  expectRefusal("query " + q + " --state 1,2,x", 2, {"value 3"});
  expectRefusal("query " + q + " --state 1,2,3 --set agent.step_size=1", 2, {"agent.step_size"});
  expectRefusal("query " + folder.file("none") + " --state 0,0,0", 3, {"none", "No such file"});
  expectRefusal("query " + folder.file("") + " --state 0,0,0", 3, {"regular file"});
}

TEST(Files, SliceWritesAPlane) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors"), out = folder.file("slice.csv");
  run("train --minutes 0.2 --save " + q);
  ASSERT_EQ(surefoot("slice " + q + " --axes pole_angle,pole_rate --at 0,0,1 --points 7 --out " + out).code, 0);
  std::istringstream in(contentOf(out));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "pole_angle,pole_rate,q -1.5,q -0.75,q 0,q 0.75,q 1.5,greedy,visits");
  int rows = 0;
  while (std::getline(in, line)) {
    ++rows;
    if (rows != 25) continue;  // the middle of 7 × 7
    const auto q0 = run("query " + q + " --state 0,0,1")["q"][0].get<double>();
    EXPECT_TRUE(line.starts_with("0,0,")) << line;
    EXPECT_EQ(std::stod(line.substr(4)), q0);
  }
  EXPECT_EQ(rows, 49);
  expectRefusal("slice " + q + " --axes pole_angle,pole_rate --out " + out, 3, {"exists"});
  expectRefusal("slice " + q + " --axes pole_angle,pole_angle --out x", 2, {"twice"});
  expectRefusal("slice " + q + " --axes pole_angle,pole_rat --out x", 2, {"pole_rate"});
  expectRefusal("slice " + q + " --axes pole_angle --out x", 2, {"two variables"});
  expectRefusal("slice " + q + " --out x", 2, {"--axes"});
}

TEST(Files, InspectAndResample) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors"), coarse = folder.file("coarse.safetensors");
  run("train --minutes 0.5 --scenario 2 --seed 7 --save " + q);
  const Json about = run("inspect " + q);
  EXPECT_EQ(about["about"]["configuration"]["scenario"], "2");
  EXPECT_EQ(about["about"]["seed"], 7);
  EXPECT_EQ(about["tensors"].size(), 2u);
  EXPECT_NE(surefoot("inspect " + q).out.find("scenario 2"), std::string::npos);
  const Json error = run("resample " + q + " --set features.scale=0.7 --save " + coarse);
  EXPECT_GT(error["rms_error"].get<double>(), 0.0);
  expectRefusal("train --minutes 0.1 --set features.scale=1 --load " + coarse, 3, {"tile_width", "resample"});
  EXPECT_EQ(run("train --minutes 0.1 --load " + coarse)["configuration"]["parameters"]["features.scale"], 0.7);
  EXPECT_EQ(run("train --minutes 0.1 --load " + coarse)["began_with"]["file"],
            std::filesystem::path(coarse).filename().string());
  expectRefusal("resample " + q + " --save x", 2, {"--set"});
  expectRefusal("resample " + q + " --set policy.epsilon=0.1 --save x", 2, {"policy.epsilon"});
  expectRefusal("resample " + q + " --set features.scale=0.7", 2, {"--save"});
}

TEST(Files, PreLearningOnAWrongModelSavesFalls) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors");
  const Json pre = run("train --scenario 2 --until 180 --episodes 20000 --save " + q)["lives"][0];
  EXPECT_GE(pre["average_reward"].get<double>(), 180.0);
  const auto falls = [](const std::string& arguments) {
    double sum = 0.0;
    const Json result = run("train --episodes 300 --lives 6 " + arguments);
    for (const Json& life : result["lives"]) sum += life["falls"].get<double>();
    return sum;
  };
  EXPECT_LT(falls("--scenario actual --load " + q), 0.6 * falls(""));
}

TEST(Files, AHashedTableReportsItsOccupancy) {
  const Json table = run("train --minutes 0.5 --set features.memory=2000")["lives"][0]["tables"][0];
  EXPECT_EQ(table["features"], 2000);
  EXPECT_EQ(table["occupied"], 2000);
  EXPECT_GT(table["failed_look_ups"].get<int>(), 0);
}

TEST(Files, TheRuleOfThumbIsThatOfTheLife) {
  const Json life = run("train --minutes 20")["lives"][0];
  const Json rule = life["rule_of_thumb"];
  EXPECT_NEAR(rule["threshold"].get<double>(), std::pow(0.98, rule["transitions"].get<double>()) * 200, 1e-9);
  EXPECT_EQ(rule["discount"], 0.98);
  EXPECT_EQ(rule["reward"], 200.0);
  EXPECT_EQ(rule["time_reward"], 0.0);
  EXPECT_EQ(rule["lower_limit"], rule["threshold"]);
  EXPECT_GT(rule["upper_limit"].get<double>(), rule["lower_limit"].get<double>()) << "successes grow shorter";
}

TEST(Files, TwoResultsDoNotGoIntoOneFile) {
  const Folder folder;
  const std::string file = folder.file("x"), again = folder.file("./x");
  expectRefusal("train --episodes 3 --save " + file + " --log " + again, 2, {"--save", "--log"});
  expectRefusal("train --episodes 3 --save " + file + " --checkpoint " + file, 2, {"--checkpoint", "--save"});
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Files, AByteThatWasChangedIsNoticed) {
  const Folder folder;
  const std::string file = folder.file("q");
  run("train --episodes 20 --environment chain --save " + file);
  std::string bytes = contentOf(file);
  bytes[bytes.size() - 3] ^= 1;  // a mantissa bit of a weight
  std::ofstream(file, std::ios::binary) << bytes;
  expectRefusal("query " + file + " --state 5", 3, {"checksum"});
  expectRefusal("train --episodes 1 --environment chain --load " + file, 3, {"checksum"});
}

TEST(Files, AResampledFunctionIsFiniteInAnyMemory) {
  const Folder folder;
  const std::string q = folder.file("q"), small = folder.file("small");
  run("train --episodes 100 --environment mountain-car --save " + q);
  for (const char* memory : {"1", "8", "100"}) {
    EXPECT_TRUE(
        run("resample " + q + " --set features.memory=" + memory + " --save " + small)["rms_error"].is_number());
    EXPECT_EQ(surefoot("query " + small + " --state 0,0").code, 0);
    std::filesystem::remove(small);
  }
}

TEST(Files, WhatHasNoEffectIsRefused) {
  const Folder folder;
  const std::string file = folder.file("life");
  expectRefusal("train --episodes 3 --set policy.epsilon_end=0.5", 2, {"policy.epsilon_schedule"});
  expectRefusal("train --episodes 3 --set shaping.scale=2", 2, {"shaping.rewards"});
  expectRefusal("train --episodes 3 --at 5:environment.start_angle=1.5", 2, {"step 5", "start_angle", "fall_angle"});
  run("train --episodes 5 --environment chain --checkpoint " + file);
  expectRefusal("train --episodes 4 --resume " + file, 2, {"--resume", "5 episodes"});
  expectRefusal("slice " + file + " --axes state --out x", 2, {"two state variables"});
  const Finished diverged = surefoot(
      "train --episodes 5000 --set agent.step_size=2 --set agent.discount=1 --set agent.trace=accumulating --save " +
      folder.file("q"));
  EXPECT_EQ(diverged.code, 4);
  EXPECT_NE(diverged.err.find("nothing of it is saved"), std::string::npos) << diverged.err;
  EXPECT_FALSE(std::filesystem::exists(folder.file("q")));
}

TEST(Files, AFileOfManyGenerationsIsStillRead) {
  const Folder folder;
  const std::string life = "train --environment random-walk --features table --episodes 3 ";
  std::string last = folder.file("0");
  run(life + "--save " + last);
  for (int i = 1; i <= 40; ++i) {
    const std::string next = folder.file(std::to_string(i));
    run(life + "--load " + last + " --save " + next);
    last = next;
  }
  EXPECT_EQ(surefoot("inspect " + last).code, 0);
}

TEST(Files, HugeOrStrangeFilesAreRefusedBeforeTheyAreRead) {
  const Folder folder;
  const std::string big = folder.file("big");
  std::ofstream(big) << "";
  std::filesystem::resize_file(big, 1ull << 40);
  for (const char* command : {"inspect ", "replay ", "query --state 0,0,0 ", "statistics ", "experiment --dry-run "})
    expectRefusal(command + big + (std::string(command).starts_with("experiment") ? ".toml" : ""), 3, {"big"});
  expectRefusal("inspect $(printf 'q\\377')", 3, {"q\\xff", "cannot be read"});
  ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
  for (const char* command : {"statistics ", "export --csv x ", "inspect ", "train --from "})
    expectRefusal(command + folder.file("pipe"), 3, {"regular file"});
}

TEST(Files, WhatCannotBeWrittenInItsPlaceIsKeptElsewhere) {
  const Folder folder;
  const std::string gone = folder.file("gone");
  std::filesystem::create_directory(gone);
  const std::string said = folder.file("said");
  surefoot("train --minutes 60 --save " + gone + "/q 2>" + said + " & sleep 0.2; rm -r " + gone + "; wait $!");
  const std::string err = contentOf(said);
  const auto at = err.find("It is in ");
  ASSERT_NE(at, std::string::npos) << err;
  const std::string place = err.substr(at + 9, err.find(" instead", at) - at - 9);
  EXPECT_EQ(surefoot("inspect " + place).code, 0);
  std::filesystem::remove(place);
}

}  // namespace surefoot
