// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "tests/app/program.h"

namespace surefoot {

using Json = nlohmann::json;

namespace {

Json train(const std::string& arguments) {
  const Finished run = surefoot("train " + arguments + " --json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "") << "no progress in a pipe";
  return Json::parse(run.out);
}

}  // namespace

TEST(Train, JsonSaysEverythingOfEveryLife) {
  const Json json = train(
      "--environment pendulum --scenario actual --agent sarsa --features tile-coder --policy softmax "
      "--set policy.temperature=1 --seed 5 --episodes 30 --lives 3");
  EXPECT_TRUE(json["version"].is_string());
  EXPECT_EQ(json["seed"], 5);
  EXPECT_EQ(json["configuration"]["policy"], "softmax");
  EXPECT_EQ(json["configuration"]["parameters"]["policy.temperature"], 1.0);
  EXPECT_EQ(json["configuration"]["parameters"]["agent.trace"], "replacing");
  ASSERT_EQ(json["lives"].size(), 3u);
  for (const Json& life : json["lives"]) {
    EXPECT_EQ(life["episodes"], 30);
    EXPECT_LE(life["falls"].get<int>() + life["successes"].get<int>(), 30);
    EXPECT_NEAR(life["simulated_minutes"].get<double>(), life["steps"].get<double>() * 0.005 / 60, 1e-9);
    EXPECT_GT(life["steps_per_second"].get<double>(), 0);
    EXPECT_EQ(life["hash"].get<std::string>().size(), 16u);
    for (const char* key : {"average_reward", "transitions_success", "transitions_failure"})
      EXPECT_TRUE(life.contains(key));
  }
}

TEST(Train, TheSameHashForOneAndTwoJobs) {
  const auto hashes = [](const std::string& jobs) {
    std::vector<std::string> list;
    const Json json = train("--lives 5 --episodes 40 --seed 9 --jobs " + jobs);
    for (const Json& life : json["lives"]) list.push_back(life["hash"]);
    return list;
  };
  const auto one = hashes("1");
  EXPECT_EQ(one.size(), 5u);
  EXPECT_EQ(one, hashes("2"));
}

// Falls that are taken back are told apart from falls, and only where there may be some.
TEST(Train, RewindsAreCountedApart) {
  const Folder folder;
  const auto rows = [&](const std::string& name, const std::string& options) {
    const std::string log = folder.file(name);
    const Json life = train("--lives 2 --episodes 40 --log " + log + options)["lives"][1];
    return std::pair{life, contentOf(log)};
  };
  const auto [life, log] = rows("rewound.csv", " --rewind 20 --set life.rewinds=2");
  EXPECT_GT(life["rewinds"], 0);
  EXPECT_LT(life["falls"].get<int>() + life["successes"].get<int>(), 41);
  EXPECT_EQ(log.substr(0, log.find('\n')),
            "life,episode,transitions,reward,falls,ending,average_reward,steps,simulated_minutes,rewinds");
  std::istringstream lines(log);
  int rewinds = 0;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("1,")) rewinds += std::stoi(line.substr(line.rfind(',') + 1));
  EXPECT_EQ(life["rewinds"], rewinds);
  const auto [plain, plainLog] = rows("plain.csv", "");
  EXPECT_FALSE(plain.contains("rewinds"));
  EXPECT_EQ(plainLog.find("rewinds"), std::string::npos);
  expectRefusal("train --episodes 1 --rewind -1", 2, {"life.rewind", "-1"});
  expectRefusal("train --episodes 1 --set life.rewinds=2", 2,
                {"life.rewinds: it has no effect while life.rewind is 0"});
}

TEST(Train, EndsAtMinutesOrEpisodesWhicheverComesFirst) {
  EXPECT_EQ(train("--minutes 0.5 --episodes 1000000")["lives"][0]["steps"], 6000);
  EXPECT_EQ(train("--minutes 500 --episodes 4")["lives"][0]["episodes"], 4);
}

TEST(Train, MeansWithoutAnythingToAverageAreNull) {
  const Json life =
      train("--episodes 1 --set environment.max_steps=1 --set environment.start_angle=0.2 --seed 3")["lives"][0];
  EXPECT_TRUE(life["transitions_success"].is_null());
  EXPECT_TRUE(life["transitions_failure"].is_null());
}

TEST(Train, TheLogHasARowAnEpisodeOfEveryLife) {
  const Folder folder;
  const Json json = train("--lives 2 --episodes 25 --log " + folder.file("log.csv"));
  std::istringstream in(contentOf(folder.file("log.csv")));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "life,episode,transitions,reward,falls,ending,average_reward,steps,simulated_minutes");
  int rows = 0, falls = 0;
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 9u) << line;
    EXPECT_EQ(cells[0], std::to_string(rows / 25));
    EXPECT_EQ(cells[1], std::to_string(rows % 25 + 1));
    falls += std::stoi(cells[4]);
    ++rows;
  }
  EXPECT_EQ(rows, 50);
  EXPECT_EQ(falls, json["lives"][0]["falls"].get<int>() + json["lives"][1]["falls"].get<int>());
}

TEST(Train, RefusesALogThatExistsOrCannotBe) {
  const Folder folder;
  std::ofstream(folder.file("old.csv")) << "old";
  expectRefusal("train --episodes 1 --log " + folder.file("old.csv"), 3, {"old.csv", "exists"});
  EXPECT_EQ(contentOf(folder.file("old.csv")), "old");
  expectRefusal("train --episodes 1 --log " + folder.file("none/new.csv"), 3, {"none/new.csv"});
  expectRefusal("train --episodes 1 --log ''", 2, {"--log"});
  expectRefusal("train --episodes 1 --log " + folder.file(""), 3);
}

TEST(Train, SaysWhenStandardOutputIsFull) {
  const std::string command = std::string(SUREFOOT_PROGRAM) + " train --episodes 1 --json >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 3);
}

TEST(Train, CtrlCEndsItWithWhatWasDone) {
  const Folder folder;
  const std::string command = std::string("timeout -s INT 1 ") + SUREFOOT_PROGRAM +
                              " train --minutes 900000 --lives 4 --json >" + folder.file("out") + " 2>" +
                              folder.file("err") + "; echo $? >" + folder.file("code");
  ASSERT_EQ(std::system(("timeout --preserve-status 20 sh -c '" + command + "'").c_str()), 0);
  const Json json = Json::parse(contentOf(folder.file("out")));
  EXPECT_GE(json["lives"].size(), 1u);
  EXPECT_EQ(json["lives"][0]["complete"], false);
  EXPECT_EQ(contentOf(folder.file("code")), "124\n") << "timeout's own, not a death by signal";
  EXPECT_NE(contentOf(folder.file("err")).find("interrupted"), std::string::npos);
}

// `timeout` sends its signal to the program and then to its group: twice within a moment.
TEST(Train, ASignalThatComesTwiceAtOnceIsOneWish) {
  const Folder folder;
  const std::string command = std::string(SUREFOOT_PROGRAM) +
                              " train --minutes 900000 --jobs 1 --set environment.substeps=100 --json --log " +
                              folder.file("log.csv") + " >" + folder.file("out") +
                              " 2>/dev/null & p=$!; sleep 1; kill -TERM $p; kill -TERM $p; wait $p; test $? = 130";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(Json::parse(contentOf(folder.file("out")))["lives"].size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(folder.file("log.csv")));
}

TEST(Train, NothingIsLeftBehindWhenItIsKilled) {
  const Folder folder;
  const std::string command =
      std::string(SUREFOOT_PROGRAM) + " train --minutes 900000 --jobs 1 --log " + folder.file("log.csv") +
      " & p=$!; sleep 0.4; kill -KILL $p || exit 9; wait $p; test -z \"$(ls -A " + folder.file("") + ")\"";
  EXPECT_EQ(std::system(("sh -c '" + command + "' 2>/dev/null").c_str()), 0);
}

TEST(Train, ALogThatCannotBeWrittenAtTheEndDoesNotTakeTheResultWithIt) {
  const Folder folder;
  const int code =
      std::system(("(ulimit -f 8; exec " + std::string(SUREFOOT_PROGRAM) + " train --episodes 3000 --json --log " +
                   folder.file("log.csv") + " 2>" + folder.file("err") + ") | grep -q '\"hash\"'")
                      .c_str());
  EXPECT_EQ(code, 0) << "the result is printed all the same";
  EXPECT_NE(contentOf(folder.file("err")).find("log.csv cannot be written"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.file("log.csv")));
}

// The rows go to the disk while lives go on: in memory they would need 150 MB, and as much again as text.
TEST(Train, ALogOfAnyLengthNeedsNoMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more address space than this leaves";
#endif
  constexpr std::int64_t kEpisodes = 800'000;
  const Folder folder;
  const std::string command = "ulimit -v 160000; exec " + std::string(SUREFOOT_PROGRAM) +
                              " train --environment chain --lives 2 --jobs 2 --episodes " + std::to_string(kEpisodes) +
                              " --log " + folder.file("log.csv") + " >/dev/null 2>" + folder.file("err");
  ASSERT_EQ(std::system(command.c_str()), 0) << contentOf(folder.file("err"));
  std::ifstream log(folder.file("log.csv"));
  std::int64_t rows = 0;
  std::string line;
  std::getline(log, line);
  EXPECT_EQ(line.substr(0, 13), "life,episode,");
  for (; std::getline(log, line); ++rows) {
    const std::string expected = (rows < kEpisodes ? "0," : "1,") + std::to_string(rows % kEpisodes + 1) + ",";
    ASSERT_EQ(line.substr(0, expected.size()), expected);
  }
  EXPECT_EQ(rows, 2 * kEpisodes);
}

// Four tables of 300 MB do not fit into 700 MB.
TEST(Train, TooLittleMemoryIsASentence) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer needs more address space than this leaves";
#endif
  const Folder folder;
  const int status = std::system(("ulimit -v 700000; " + std::string(SUREFOOT_PROGRAM) +
                                  " train --episodes 2000 --jobs 4 --lives 4 --set features.scale=5 >/dev/null 2>" +
                                  folder.file("err"))
                                     .c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_NE(contentOf(folder.file("err")).find("memory"), std::string::npos);
}

// The terminal is closed while the progress line is drawn: the log is still written.
TEST(Train, AClosedTerminalDoesNotTakeTheLogWithIt) {
  const Folder folder;
  const std::string command = "timeout 2 script -qec '" + std::string(SUREFOOT_PROGRAM) +
                              " train --minutes 900000 --jobs 1 --log " + folder.file("log.csv") +
                              " & sleep 1; kill -HUP $!; wait $!; echo $? >" + folder.file("code") +
                              "' /dev/null >/dev/null";
  if (std::system("command -v script >/dev/null") != 0) GTEST_SKIP() << "script(1) is not installed";
  static_cast<void>(std::system(command.c_str()));
  EXPECT_EQ(contentOf(folder.file("code")), "130\n");
  EXPECT_TRUE(std::filesystem::exists(folder.file("log.csv")));
}

TEST(Train, DivergenceHasAnExitCodeOfItsOwn) {
  const Finished run = surefoot(
      "train --episodes 5000 --set agent.step_size=2 --set agent.discount=1 --set agent.trace=accumulating --json");
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("agent.trace"), std::string::npos) << run.err;
  EXPECT_TRUE(Json::parse(run.out)["lives"][0].contains("diverged"));
}

}  // namespace surefoot
