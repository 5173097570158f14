// SPDX-License-Identifier: GPL-3.0-or-later
// experiment, statistics, export and merge, as a user runs them.
#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/app/program.h"

namespace surefoot {

namespace {

const char* const kPlan = R"(
title = "Three policies"
lives = 8
reference = "ε-greedy"
[base]
minutes = 1
[pre-learning]
scenario = "2"
until = 150
pool = 4
[[condition]]
name = "ε-greedy"
[[condition]]
name = "TRL {policy.threshold}"
policy = "trl"
set.policy.threshold = [0, 50]
)";

class LaboratoryCommands : public testing::Test {
 protected:
  LaboratoryCommands() { std::ofstream(file("plan.toml")) << kPlan; }
  std::string file(const std::string& name) const { return folder.file(name); }
  /// The last line that `experiment --json` prints.
  nlohmann::json experiment(const std::string& arguments, int code = 0) const {
    const Finished run = surefoot("experiment " + file("plan.toml") + " --json " + arguments);
    EXPECT_EQ(run.code, code) << run.err;
    const auto end = run.out.find_last_not_of('\n');
    if (end == std::string::npos) return {};
    const auto begin = run.out.rfind('\n', end);
    return nlohmann::json::parse(run.out.substr(begin == std::string::npos ? 0 : begin + 1));
  }
  Folder folder;
};

}  // namespace

TEST_F(LaboratoryCommands, AStoreIsMadeReadAndExported) {
  const auto done = experiment("--out " + file("r.sqlite"));
  EXPECT_EQ(done["lives"], 24);
  EXPECT_EQ(done["complete"], true);

  const auto statistics = run("statistics " + file("r.sqlite"));
  ASSERT_EQ(statistics["conditions"].size(), 3u);
  EXPECT_EQ(statistics["conditions"][0]["lives"], 8);
  EXPECT_TRUE(statistics["conditions"][2]["against_reference"]["change_per_cent"]["low"].is_number());
  const Finished table = surefoot("statistics " + file("r.sqlite"));
  EXPECT_NE(table.out.find("TRL 50"), std::string::npos) << table.out;

  EXPECT_EQ(surefoot("export " + file("r.sqlite") + " --csv " + file("csv")).code, 0);
  const std::string lives = contentOf(file("csv/lives.csv"));
  EXPECT_EQ(std::count(lives.begin(), lives.end(), '\n'), 25);
  std::int64_t episodes = 0;
  std::istringstream rows(lives);
  std::string row;
  std::getline(rows, row);
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string cell;
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    episodes += std::stoll(cell);
  }
  const std::string all = contentOf(file("csv/episodes.csv"));
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), episodes + 1);
  expectRefusal("export " + file("r.sqlite") + " --csv " + file("csv"), 3, {"exists already"});
}

TEST_F(LaboratoryCommands, JobsAndShardsChangeNothing) {
  const auto hash = experiment("--jobs 1 --out " + file("one.sqlite"))["content_hash"];
  EXPECT_EQ(experiment("--jobs 3 --out " + file("three.sqlite"))["content_hash"], hash);
  std::string parts, firstFour;
  for (int i = 1; i <= 5; ++i) {
    const std::string part = file("part" + std::to_string(i));
    experiment("--shard " + std::to_string(i) + "/5 --out " + part);
    parts += part + " ";
    if (i == 4) firstFour = parts;
    if (i == 4) expectRefusal("merge " + parts + " --out " + file("m.sqlite"), 3, {"shard 5 of 5"});
  }
  const Finished merged = surefoot("merge " + parts + " --out " + file("m.sqlite"));
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_NE(merged.out.find(hash.get<std::string>()), std::string::npos) << merged.out;
  expectRefusal("merge " + parts + " --out " + file("m.sqlite"), 3, {"exists already"});
  experiment("--seed 2 --shard 5/5 --out " + file("other"));
  expectRefusal("merge " + firstFour + file("other") + " --out " + file("n.sqlite"), 3, {"seed"});
}

TEST_F(LaboratoryCommands, KilledAtAnyMomentItGoesOnToTheSameContent) {
  const auto start = std::chrono::steady_clock::now();
  const auto hash = experiment("--out " + file("whole.sqlite"))["content_hash"];
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  constexpr int kKills = 8;
  for (int kill = 0; kill < kKills; ++kill) {
    const std::string store = file("killed" + std::to_string(kill) + ".sqlite");
    const double moment = whole * (kill + 0.5) / kKills;
    std::system(("timeout -s KILL " + std::to_string(moment) + " " + SUREFOOT_PROGRAM + " experiment " +
                 file("plan.toml") + " --out " + store + " >/dev/null 2>&1")
                    .c_str());
    EXPECT_EQ(experiment("--resume --out " + store)["content_hash"], hash) << "killed after " << moment << " s";
  }
}

TEST_F(LaboratoryCommands, AnInterruptKeepsWhatIsDone) {
  const std::string store = file("s.sqlite");
  const Finished run = [&] {
    const std::string command = std::string("timeout -s INT 1 ") + SUREFOOT_PROGRAM + " experiment " +
                                file("plan.toml") + " --lives 2000 --out " + store + " >/dev/null 2>" + file("err");
    const int status = std::system(command.c_str());
    return Finished{WEXITSTATUS(status), "", contentOf(file("err"))};
  }();
  EXPECT_NE(run.err.find("--resume"), std::string::npos) << run.err;
  const auto statistics = surefoot("statistics " + store);
  EXPECT_EQ(statistics.code, 0) << statistics.err;
  EXPECT_NE(statistics.out.find("Not all planned lives"), std::string::npos);
}

TEST_F(LaboratoryCommands, ADryRunWritesNothing) {
  const auto plan = run("experiment " + file("plan.toml") + " --dry-run --lives 3 --out " + file("r.sqlite"));
  EXPECT_EQ(plan["lives"], 3);
  EXPECT_EQ(plan["conditions"].size(), 3u);
  EXPECT_FALSE(std::filesystem::exists(file("r.sqlite")));
}

TEST_F(LaboratoryCommands, ShippedPlansAreFoundByNameAndAreSound) {
  const Finished list = surefoot("experiment nothing-like-this");
  EXPECT_EQ(list.code, 3);
  for (const auto& entry : std::filesystem::directory_iterator(std::string(SUREFOOT_SOURCE) + "/resources/plans")) {
    if (entry.is_directory()) continue;
    const std::string name = entry.path().stem().string();
    EXPECT_NE(list.err.find(name), std::string::npos) << list.err;
    EXPECT_EQ(surefoot("experiment " + name + " --dry-run").code, 0) << name;
  }
}

TEST_F(LaboratoryCommands, TheSearchesForSizesOfCautionAreSound) {
  const std::string plans = std::string(SUREFOOT_SOURCE) + "/resources/plans/caution-search";
  for (const auto& entry : std::filesystem::directory_iterator(plans)) {
    const Finished plan = surefoot("experiment " + entry.path().string() + " --dry-run");
    EXPECT_EQ(plan.code, 0) << plan.err;
    EXPECT_NE(plan.out.find(" in all for the search"), std::string::npos) << entry.path() << plan.out;
  }
}

TEST_F(LaboratoryCommands, EveryRecipeIsASoundPlan) {
  int recipes = 0;
  const std::string recipesFolder = std::string(SUREFOOT_SOURCE) + "/resources/recipes";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(recipesFolder)) {
    if (entry.is_directory()) continue;
    const Finished plan = surefoot("experiment " + entry.path().string() + " --dry-run");
    EXPECT_EQ(plan.code, 0) << plan.err;
    const std::string name = entry.path().stem().string();
    const std::string series = name == "caution-leo-greedy" ? "caution-leo" : name;  // its ε .05 and greedy, on purpose
    EXPECT_NE(contentOf(entry.path().string()).find("\nseries = \"" + series + "\"\n"), std::string::npos) << name;
    ++recipes;
  }
  EXPECT_GT(recipes, 50);
}

TEST_F(LaboratoryCommands, ReproduceTellsBeforehandWhatItWouldDo) {
  const Finished all = surefoot("reproduce all --dry-run --seed 1 2 --out " + file("nowhere"));
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_NE(all.out.find("4.10: TRL without pre-learning; 10 conditions, 40 lives each, about "), std::string::npos);
  EXPECT_NE(all.out.find(" for 2 master seeds"), std::string::npos) << all.out;
  for (const char* apart : {"walker-scratch", "pendulums"})
    EXPECT_EQ(all.out.find(apart), std::string::npos) << apart << " takes long and is run by its name only";
  EXPECT_NE(surefoot("reproduce pendulums --dry-run").out.find("360 conditions"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file("nowhere")));
  const Finished wrong = surefoot("reproduce all --dry-run --preset lba");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_NE(wrong.err.find("lab"), std::string::npos) << wrong.err;
}

TEST_F(LaboratoryCommands, ReproduceOnAnotherPresetLeavesOutWhatHasNone) {
  const Finished lab = surefoot("reproduce 2.1 4.3 --preset lab --lives 2 --out " + file("lab"));
  ASSERT_EQ(lab.code, 0) << lab.err;
  EXPECT_EQ(lab.out.find("2.1:"), std::string::npos) << "the cliff has no presets";
  const auto claims = nlohmann::json::parse(contentOf(file("lab") + "/claims.json"));
  ASSERT_FALSE(claims.empty());
  for (const auto& claim : claims) EXPECT_EQ(claim["preset"], "lab");
}

// All of it under each of several master seeds, and which verdicts are the same.
TEST_F(LaboratoryCommands, ReproduceTellsHowStableItsVerdictsAre) {
  const std::string out = file("seeds");
  const Finished done = surefoot("reproduce 6.2 --lives 3 --seed 1 --seed 7 --out " + out);
  ASSERT_EQ(done.code, 0) << done.err;
  const auto stability = nlohmann::json::parse(contentOf(out + "/stability.json"));
  ASSERT_GE(stability.size(), 2u);
  for (const auto& row : stability) {
    EXPECT_EQ(row["verdicts"].size(), 2u);
    EXPECT_EQ(row["stable"], row["verdicts"]["1"] == row["verdicts"]["7"]);
  }
  EXPECT_NE(contentOf(out + "/stability.md").find("master seeds 1, 7"), std::string::npos);
  const auto one = nlohmann::json::parse(contentOf(out + "/seed-1/claims.json"));
  const auto seven = nlohmann::json::parse(contentOf(out + "/seed-7/claims.json"));
  EXPECT_NE(one[0]["ours"], seven[0]["ours"]) << "other lives";
}

TEST_F(LaboratoryCommands, ReproduceRunsDrawsJudgesAndReports) {
  const std::string out = file("rep");
  const Finished first = surefoot("reproduce 4.3 --lives 3 --out " + out);
  ASSERT_EQ(first.code, 0) << first.err;
  const auto claims = nlohmann::json::parse(contentOf(out + "/claims.json"));
  ASSERT_GT(claims.size(), 5u);
  EXPECT_EQ(claims[0]["id"], "B1");
  EXPECT_EQ(claims[0]["thesis"], 290);
  EXPECT_TRUE(claims[0]["low"].is_number());
  for (const auto& claim : claims) {
    const std::string verdict = claim["verdict"];
    EXPECT_TRUE(verdict == "agrees" || verdict == "differs" || verdict == "undecided") << verdict;
  }
  EXPECT_TRUE(std::any_of(claims.begin(), claims.end(), [](const auto& c) { return c["preset"] == "lab"; }));
  EXPECT_GT(contentOf(out + "/4.3/4.3a.csv").size(), 1000u);
  const std::string html = contentOf(out + "/report.html");
  EXPECT_NE(html.find("B11"), std::string::npos);
  EXPECT_NE(html.find("<th>falls during learning</th>"), std::string::npos) << "the table of the conditions";
  if (first.err.empty()) {  // built with its window
    EXPECT_EQ(contentOf(out + "/4.3/4.3a.png").substr(1, 3), "PNG");
    EXPECT_EQ(contentOf(out + "/4.3/4.3a.pdf").substr(0, 4), "%PDF");
    EXPECT_NE(html.find("data:image/png;base64,iVBOR"), std::string::npos);
  }
  const Finished again = surefoot("reproduce 4.3 --lives 3 --out " + out);
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(nlohmann::json::parse(contentOf(out + "/claims.json")), claims) << "from what is there already";
  expectRefusal("reproduce 4.3 --lives 4 --out " + out, 3, {"3 lives", "4"});
  expectRefusal("reproduce", 2, {"LIST"});
  expectRefusal("reproduce 4.3 --seed one", 2, {"--seed", "one"});
  expectRefusal("reproduce 4.3 --seed 1 --seed 1", 2, {"1 is named twice"});
  expectRefusal("reproduce 9.9", 2, {"9.9"});
  expectRefusal("reproduce 4.3 --lives none", 2, {"--lives"});
}

TEST_F(LaboratoryCommands, AWrongRecipeIsRefusedInASentence) {
  const auto refuse = [&](const std::string& more, const std::vector<std::string>& words) {
    std::ofstream(file("r.toml")) << "lives = 2\n[[condition]]\nname = \"a\"\nminutes = 0.1\n" << more;
    expectRefusal("reproduce " + file("r.toml") + " --out " + file("out"), 2, words);
  };
  refuse("[[figure]]\nname = \"f\"\nkind = \"pie\"\n", {"figure f", "pie"});
  refuse("[[figure]]\nname = \"../f\"\nkind = \"bars\"\n", {"slash"});
  refuse("[[figure]]\nname = \"f\"\nkind = \"bars\"\ncolour = 3\n", {"colour"});
  refuse("[[figure]]\nname = \"f\"\nkind = \"bars\"\nconditions = [\"b\"]\n",
         {"figure f", "conditions", "none is called \"b\""});
  EXPECT_FALSE(std::filesystem::exists(file("out"))) << "it is told before a life is lived";
  refuse("[[claim]]\nid = \"X\"\nkind = \"value\"\nthesis = 3\nconditions = [\"b\"]\n", {"claim X", "b"});
  refuse("[[claim]]\nkind = \"value\"\n", {"id"});
  refuse("[claim]\nid = \"X\"\n", {"claim", "[[claim]]"});
  std::ofstream(file("t.toml")) << "lives = 2\ntable = [\"height\"]\n[[condition]]\nname = \"a\"\nminutes = 1\n";
  expectRefusal("reproduce " + file("t.toml") + " --out " + file("out"), 2, {"table", "height"});
}

TEST_F(LaboratoryCommands, WhatCannotBeIsRefusedInASentence) {
  const std::string plan = file("plan.toml"), store = file("r.sqlite");
  experiment("--lives 2 --out " + store);
  expectRefusal("experiment", 2, {"PLAN"});
  expectRefusal("experiment " + file("absent.toml"), 3, {"absent.toml"});
  expectRefusal("experiment quik", 3, {"did you mean quick"});
  expectRefusal("experiment " + plan + " --out " + store, 3, {"exists already", "--resume"});
  expectRefusal("experiment " + plan + " --lives 1 --resume --out " + store, 2, {"--lives", "2"});
  expectRefusal("experiment " + plan + " --lives 2 --seed 7 --resume --out " + store, 3, {"seed", "1", "7"});
  expectRefusal("experiment " + plan + " --lives 2 --shard 1/2 --resume --out " + store, 3, {"shard"});
  expectRefusal("experiment " + plan + " --set agent.trace_decay=0.5 --lives 2 --resume --out " + store, 3,
                {"condition 1", "trace_decay"});
  expectRefusal("experiment " + plan + " --lives 0 --out " + file("x"), 2, {"--lives"});
  expectRefusal("experiment " + plan + " --shard 3/2 --out " + file("x"), 2, {"--shard"});
  expectRefusal("experiment " + plan + " --set policy.threshold=3 --out " + file("x"), 2, {"policy.threshold"});
  expectRefusal("experiment " + plan + " --out " + file("no/folder/x"), 3, {"folder"});
  expectRefusal("experiment " + plan + " --resume --out " + plan, 3, {"not a store"});
  expectRefusal("statistics", 2, {"STORE"});
  expectRefusal("statistics " + file("absent"), 3, {"absent"});
  expectRefusal("statistics " + plan, 3, {"not a store"});
  expectRefusal("export " + store, 2, {"--csv"});
  expectRefusal("merge --out " + file("x"), 2, {"PARTS"});
  expectRefusal("merge " + store, 2, {"--out"});
}

TEST_F(LaboratoryCommands, WhatAKilledRunLeftIsNotReplayedIntoTheNextStore) {
  const std::string store = file("r.sqlite"), clean = file("clean.sqlite");
  surefoot("experiment " + file("plan.toml") + " --out " + store + " --set policy.epsilon=0.5 & sleep 0.6; kill -9 $!");
  std::filesystem::remove(store);
  const auto hash = experiment("--out " + store)["content_hash"];
  EXPECT_EQ(hash, experiment("--out " + clean)["content_hash"]);
}

TEST_F(LaboratoryCommands, MergeTouchesNothingButItsResult) {
  experiment("--out " + file("whole.sqlite.part") + " --shard 1/2");
  experiment("--out " + file("two.sqlite") + " --shard 2/2");
  const std::string merge = "merge " + file("whole.sqlite.part") + " " + file("two.sqlite") + " --out ";
  EXPECT_EQ(surefoot(merge + file("whole.sqlite")).code, 0);
  EXPECT_TRUE(std::filesystem::exists(file("whole.sqlite.part")));
  expectRefusal(merge + file("whole.sqlite"), 3, {"exists already"});
}

TEST_F(LaboratoryCommands, ReportsOfOthersAreNotReplaced) {
  std::filesystem::create_directory(file("mine"));
  std::ofstream(file("mine/report.html")) << "notes";
  expectRefusal("reproduce 4.1 --lives 2 --out " + file("mine"), 3, {"report.html", "no report of Surefoot"});
  EXPECT_EQ(contentOf(file("mine/report.html")), "notes");
}

}  // namespace surefoot
