// SPDX-License-Identifier: GPL-3.0-or-later
// Files as a user meets them: saved, loaded, asked, resumed after a kill, replayed.
#include <chrono>
#include <cmath>
#include <regex>
#include <sstream>

#include "core/random.h"
#include "tests/app/program.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

Json run(const std::string& arguments) {
  const Finished finished = surefoot(arguments + " --json");
  EXPECT_EQ(finished.code, 0) << arguments << "\n" << finished.err;
  return finished.code == 0 ? Json::parse(finished.out) : Json::object();
}
std::string hashOf(const std::string& arguments) {
  return run("train " + arguments)["lives"][0]["hash"];
}

/// The Python of the README.
std::string example() {
  const std::string readme = contentOf(SUREFOOT_SOURCE "/README.md");
  const std::string fence = "```python\n";
  const auto begin = readme.find(fence) + fence.size();
  return readme.substr(begin, readme.find("```", begin) - begin);
}

}  // namespace

TEST(Files, TheReadmesPythonReadsWhatWasSaved) {
  const Folder folder;
  const std::string q = folder.file("q.safetensors");
  run("train --minutes 1 --save " + q);
  std::ofstream(folder.file("example.py")) << example() << R"(
import sys
about, tensors = load(sys.argv[1])
print(json.dumps(list(action_values(about, tensors, [float(x) for x in sys.argv[2].split(",")]))))
)";
  Random random(5);
  for (int i = 0; i < 10; ++i) {
    std::ostringstream state;
    state << random.uniform(-1.6, 1.6) << "," << random.uniform(-17, 17) << "," << random.uniform(-32, 32);
    const std::string command =
        "/usr/bin/python3 " + folder.file("example.py") + " " + q + " " + state.str() + " >" + folder.file("out");
    ASSERT_EQ(std::system(command.c_str()), 0) << "python3-numpy is needed";
    const auto theirs = Json::parse(contentOf(folder.file("out"))).get<std::vector<double>>();
    const auto ours = run("query " + q + " --state " + state.str())["q"].get<std::vector<double>>();
    ASSERT_EQ(theirs.size(), ours.size());
    for (std::size_t a = 0; a < ours.size(); ++a) EXPECT_NEAR(theirs[a], ours[a], 1e-12) << state.str();
  }
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
  expectRefusal("train --minutes 0.1 --load " + coarse, 3, {"tile_width", "resample"});
  EXPECT_EQ(run("train --minutes 0.1 --set features.scale=0.7 --load " + coarse)["began_with"]["file"], coarse);
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
  EXPECT_LT(falls("--load " + q), 0.6 * falls(""));
}

// 50 kills, spread over the run by a seed: whatever there is can be read, and goes on to the same end.
TEST(Files, KilledAtAnyMomentACheckpointIsWholeAndGoesOn) {
  const Folder folder;
  const std::string file = folder.file("life"), arguments = "--minutes 4 --agent sarsa-2q";
  const std::string expected = hashOf(arguments);
  const std::string fresh = std::string(SUREFOOT_PROGRAM) + " train " + arguments;
  // How long this machine takes for a start and five checkpoints: the kills are spread around it.
  const auto start = std::chrono::steady_clock::now();
  run("train --minutes 0.05 --agent sarsa-2q --every 0.01 --checkpoint " + folder.file("short"));
  const double five = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Random random(11);
  int found = 0;
  for (int kill = 0; kill < 50; ++kill) {
    const bool resuming = std::filesystem::exists(file);
    const std::string command = resuming ? std::string(SUREFOOT_PROGRAM) + " train --resume " + file : fresh;
    std::ostringstream seconds;
    seconds << random.uniform(0.2, 2.0) * five;
    static_cast<void>(std::system(
        ("timeout -s KILL " + seconds.str() + " " + command + " --checkpoint " + file + " --every 0.01 >/dev/null 2>&1")
            .c_str()));
    if (!std::filesystem::exists(file)) continue;
    ++found;
    ASSERT_EQ(surefoot("inspect " + file).code, 0) << "after kill " << kill;
    if (kill % 7 != 0) continue;
    ASSERT_EQ(hashOf("--resume " + file), expected) << "after kill " << kill;
  }
  EXPECT_GT(found, 25);
  EXPECT_EQ(hashOf("--resume " + file), expected);
}

TEST(Files, ACheckpointOfAnotherLifeIsNotOverwritten) {
  const Folder folder;
  const std::string file = folder.file("life");
  run("train --minutes 0.2 --checkpoint " + file);
  const std::string before = contentOf(file);
  expectRefusal("train --minutes 0.2 --checkpoint " + file, 3, {"exists", "--resume"});
  EXPECT_EQ(contentOf(file), before);
  expectRefusal("train --resume " + file + " --set policy.epsilon=0.1", 2, {"--set", "--resume"});
  expectRefusal("train --resume " + file + " --seed 3", 2, {"--seed"});
  expectRefusal("train --resume " + file + " --log " + folder.file("log.csv"), 2, {"--log"});
  expectRefusal("train --minutes 1 --every 3", 2, {"--checkpoint"});
  expectRefusal("train --minutes 1 --lives 2 --save x", 2, {"--save", "one life"});
  EXPECT_EQ(run("train --minutes 0.4 --resume " + file)["lives"][0]["steps"], 4800) << "it may be longer";
}

// The disk is full when a checkpoint is written: the old one stays, the run goes on, and the program says so.
TEST(Files, AFullDiskLeavesTheOldCheckpoint) {
  const Folder folder;
  const std::string file = folder.file("life");
  run("train --environment chain --episodes 5 --checkpoint " + file);
  const std::string before = contentOf(file);
  const std::string command = "(ulimit -f 1; exec " + std::string(SUREFOOT_PROGRAM) + " train --episodes 50 --resume " +
                              file + " --checkpoint " + file + " >/dev/null 2>" + folder.file("err") + ")";
  const int status = std::system(("bash -c '" + command + "'").c_str());
  EXPECT_EQ(WEXITSTATUS(status), 3);
  EXPECT_EQ(contentOf(file), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("")), {}), 2) << "the checkpoint and err";
}

TEST(Files, AJournalIsLivedAgain) {
  const Folder folder;
  const std::string journal = folder.file("life.jsonl"), q = folder.file("q");
  run("train --minutes 0.2 --save " + q);
  const std::string hash = hashOf("--minutes 1 --load " + q +
                                  " --at 500:policy.epsilon=0.2 --at 700:policy=softmax --at 900:push=0.1 --at "
                                  "2000:environment.damping=0.01 --journal " +
                                  journal);
  EXPECT_EQ(run("replay " + journal + " --verify")["lives"][0]["hash"], hash);
  const std::string text = contentOf(journal);
  std::ofstream(folder.file("other.jsonl")) << std::regex_replace(text, std::regex("\"0.2\""), "\"0.3\"");
  const Finished other = surefoot("replay " + folder.file("other.jsonl") + " --verify");
  EXPECT_EQ(other.code, 5);
  EXPECT_NE(other.err.find(hash), std::string::npos) << other.err;
  std::filesystem::remove(q);
  expectRefusal("replay " + journal, 3, {q, "No such file"});
  expectRefusal("train --minutes 1 --at 5:policy.epsilon", 2, {"STEP:KEY=VALUE"});
  expectRefusal("train --minutes 1 --at x:policy.epsilon=1", 2, {"STEP:KEY=VALUE"});
  expectRefusal("train --minutes 1 --at 5:policy.epsilon=2", 2, {"policy.epsilon", "step 5", "0 to 1"});
  expectRefusal("train --minutes 1 --at 5:features.tilings=2", 2, {"new table"});
  expectRefusal("train --episodes 1 --environment cliff --at 5:push=1", 2, {"no body"});
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

TEST(Files, ACheckpointBehindALinkStaysBehindIt) {
  const Folder folder;
  const std::string file = folder.file("life"), link = folder.file("link");
  run("train --episodes 5 --environment chain --checkpoint " + file);
  std::filesystem::create_symlink(file, link);
  run("train --episodes 9 --resume " + link + " --checkpoint " + link);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_NE(surefoot("inspect " + file).out.find("9 episodes"), std::string::npos);
}

TEST(Files, WhatCannotBeLivedAgainIsTheJournalsFault) {
  const Folder folder;
  const std::string journal = folder.file("j"), other = folder.file("other");
  run("train --episodes 20 --environment chain --at 10:policy.epsilon=0.2 --journal " + journal);
  const std::string text = contentOf(journal);
  for (const auto& [from, to] : {std::pair{"\"policy.epsilon\",\"step\"", "\"eolicy.epsilon\",\"step\""},
                                 std::pair{"\"value\":\"0.2\"", "\"value\":\"7\""},
                                 std::pair{"\"policy.epsilon\",\"step\"", "\"features.tilings\",\"step\""}}) {
    std::ofstream(other) << std::regex_replace(text, std::regex(from), to);
    expectRefusal("replay " + other, 3, {other});
  }
  std::ofstream(other) << std::regex_replace(text, std::regex("\"episodes\":20,\"falls\""),
                                             "\"episodes\":21,\"falls\"");
  EXPECT_EQ(surefoot("replay " + other + " --verify").code, 5);
}

TEST(Files, WhatHasNoEffectIsRefused) {
  const Folder folder;
  const std::string file = folder.file("life");
  expectRefusal("train --episodes 3 --set policy.epsilon_end=0.5", 2, {"policy.epsilon_schedule"});
  expectRefusal("train --episodes 3 --set shaping.scale=2", 2, {"shaping.rewards"});
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

}  // namespace surefoot
