// SPDX-License-Identifier: GPL-3.0-or-later
// What was lived is found again: after a signal, a kill, a copy, in another folder, by another version.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <chrono>
#include <regex>
#include <thread>

#include "core/life/lives_version.h"
#include "tests/app/program.h"
#include "tests/core/store/seal_store.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

const char* const kLong =
    "lives = 2\n[base]\nminutes = 60\n[pre-learning]\nscenario = \"2\"\nminutes = 30\npool = 1\n"
    "[[condition]]\nname = \"a\"\n[[condition]]\nname = \"b\"\npre-learning = false\n";
const char* const kShort = "lives = 400\n[base]\nminutes = 0.2\n[[condition]]\nname = \"a\"\n";

class GoingOn : public testing::Test {
 protected:
  GoingOn() {
    std::ofstream(file("long.toml")) << kLong;
    std::ofstream(file("short.toml")) << kShort;
  }
  std::string file(const std::string& name) const { return folder.file(name); }
  /// Runs a plan and ends it with a signal after some seconds, if it is not over before.
  void endAfter(double seconds, const char* signal, const std::string& arguments) const {
    std::system(("timeout -s " + std::string(signal) + " " + std::to_string(seconds) + " " + SUREFOOT_PROGRAM +
                 " experiment " + arguments + " >/dev/null 2>&1")
                    .c_str());
  }
  std::string contentOfRun(const std::string& arguments) const {
    const Finished run = surefoot("experiment " + arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    const auto at = run.out.rfind("content ");
    return at == std::string::npos ? "" : run.out.substr(at + 8, 16);
  }
  int livesIn(const std::string& store) const {
    constexpr int kPatience = 5'000;  // [ms], as Python has
    return SQLite::Database(store, SQLite::OPEN_READONLY, kPatience).execAndGet("SELECT count(*) FROM lives").getInt();
  }
  void sql(const std::string& store, const std::string& text) const {
    SQLite::Database db(store, SQLite::OPEN_READWRITE);
    db.exec(text);
    sealStore(db);
  }
  void replaceIn(const std::string& path, const std::string& what, const std::string& by) const {
    std::string text = contentOf(path);
    const auto at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    ASSERT_EQ(what.size(), by.size());
    std::ofstream(path, std::ios::binary) << text.replace(at, what.size(), by);
  }
  Folder folder;
};

}  // namespace

TEST_F(GoingOn, AnInterruptKeepsTheLivesInHandAndResumeTakesThemUp) {
  const std::string whole = contentOfRun(file("long.toml") + " --out " + file("whole.sqlite"));
  const std::string run = file("long.toml") + " --out " + file("s.sqlite") + " --jobs 2 ";
  endAfter(0.5, "INT", run);
  EXPECT_TRUE(fs::exists(file("s.sqlite.lives"))) << "lives of an hour are not over by now";
  int rounds = 0;
  for (; fs::exists(file("s.sqlite.lives")) && rounds < 200; ++rounds)
    endAfter(0.6, rounds % 2 == 0 ? "TERM" : "HUP", run + "--resume");
  EXPECT_LT(rounds, 200) << "every run must get further than the one before";
  EXPECT_EQ(contentOfRun(run + "--resume"), whole);
  for (const auto& entry : fs::directory_iterator(fs::path(file("x")).parent_path()))
    EXPECT_FALSE(entry.path().filename().string().starts_with("s.sqlite") && entry.path() != file("s.sqlite"))
        << entry.path() << " is litter";
}

TEST_F(GoingOn, KilledAgainAndAgainNoLifeIsLostWithTheLogOrWithout) {
  const std::string whole = contentOfRun(file("short.toml") + " --out " + file("whole.sqlite"));
  const std::string store = file("s.sqlite");
  int before = 0;
  for (int kill = 0; kill < 6; ++kill) {
    endAfter(0.5 + 0.13 * kill, "KILL", file("short.toml") + " --out " + store + " --resume");
    if (!fs::exists(store)) continue;
    // Alone, as somebody copies it who knows nothing of logs.
    const std::string copy = file("copy.sqlite");
    fs::copy_file(store, copy, fs::copy_options::overwrite_existing);
    const Finished alone = surefoot("statistics " + copy);
    EXPECT_TRUE(alone.err.find("may be missing") != std::string::npos || livesIn(copy) == livesIn(store)) << alone.err;
    EXPECT_EQ(alone.err.find("damaged"), std::string::npos) << alone.err;
    EXPECT_GE(livesIn(store), before) << "what was there stays";
    before = livesIn(store);
  }
  EXPECT_GT(before, 0);
  EXPECT_EQ(contentOfRun(file("short.toml") + " --resume --out " + store), whole);
  EXPECT_EQ(surefoot("statistics " + store).err, "");
}

TEST_F(GoingOn, ARunningStoreIsReadByStatisticsExportAndPython) {
  const std::string store = file("s.sqlite");
  std::jthread running([&] {
    std::system((std::string(SUREFOOT_PROGRAM) + " experiment " + file("short.toml") + " --lives 1000 --out " + store +
                 " >" + file("out") + " 2>&1")
                    .c_str());
  });
  for (int i = 0; i < 1000 && (!fs::exists(store) || livesIn(store) < 3); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  expectRefusal("experiment " + file("short.toml") + " --lives 1000 --resume --out " + store, 3, {"another process"});
  for (int i = 0; i < 5; ++i) {
    const Finished statistics = surefoot("statistics " + store);
    EXPECT_EQ(statistics.code, 0) << statistics.err;
    EXPECT_EQ(statistics.err, "");
    EXPECT_EQ(surefoot("export " + store + " --csv " + file("csv" + std::to_string(i))).code, 0);
    const std::string python = "python3 -c \"import sqlite3; n = sqlite3.connect('" + store +
                               "').execute('SELECT count(*) FROM lives').fetchone()[0]; assert n > 0\"";
    if (std::system("python3 -c 'import sqlite3' 2>/dev/null") == 0) {
      EXPECT_EQ(std::system(python.c_str()), 0);
    }
  }
  // What it writes is complete once it has ended.
  running.join();
  EXPECT_NE(contentOf(file("out")).find("1000 of 1000"), std::string::npos) << contentOf(file("out"));
}

TEST_F(GoingOn, WhereNothingCanBeWrittenAStoreIsRead) {
  if (std::system("setpriv --reuid 65534 --regid 65534 --clear-groups true 2>/dev/null") != 0)
    GTEST_SKIP() << "only root can be somebody who may not write";
  const std::string place = file("shelf"), store = place + "/s.sqlite";
  fs::permissions(fs::path(place).parent_path(), fs::perms(0755));
  fs::create_directory(place);
  const auto statistics = [&] {
    return std::system(("setpriv --reuid 65534 --regid 65534 --clear-groups " + std::string(SUREFOOT_PROGRAM) +
                        " statistics " + store + " >" + file("out") + " 2>" + file("err"))
                           .c_str());
  };
  endAfter(1.5, "KILL", file("short.toml") + " --lives 5000 --out " + store);
  ASSERT_GT(livesIn(store), 0);
  endAfter(1, "KILL", file("short.toml") + " --lives 5000 --resume --out " + store);
  for (const char* removed : {"-none", "-shm", "-wal"}) {
    fs::remove(store + removed);
    for (const auto& entry : fs::directory_iterator(place)) fs::permissions(entry.path(), fs::perms(0444));
    fs::permissions(place, fs::perms(0555));
    EXPECT_EQ(statistics(), 0) << removed << " " << contentOf(file("err"));
    EXPECT_EQ(contentOf(file("err")).find("may be missing") != std::string::npos, std::string(removed) == "-wal");
  }
}

TEST_F(GoingOn, LivesOfAnotherVersionAreToldAndRefusedUnlessWanted) {
  const std::string store = file("s.sqlite"), resume = "experiment " + file("short.toml") + " --resume --lives ";
  EXPECT_EQ(surefoot("experiment " + file("short.toml") + " --lives 2 --out " + store).code, 0);
  EXPECT_EQ(surefoot(resume + "3 --out " + store).code, 0) << "the same version";
  sql(store, "UPDATE experiment SET value = '9.9' WHERE key = 'version'; UPDATE lives SET program = '0.0.9'");
  EXPECT_EQ(surefoot(resume + "4 --out " + store).code, 0) << "another program of the same lives";
  sql(store, "UPDATE lives SET lives_version = 77, program = '0.0.9' WHERE life = 0");
  expectRefusal(resume + "5 --out " + store, 3, {"0.0.9", "77", "--other-version"});
  EXPECT_EQ(surefoot(resume + "5 --other-version --out " + store).code, 0);
  SQLite::Database db(store, SQLite::OPEN_READONLY);
  EXPECT_EQ(db.execAndGet("SELECT lives_version FROM lives WHERE life = 0").getInt(), 77) << "each keeps its own";
  EXPECT_EQ(db.execAndGet("SELECT count(*) FROM lives WHERE lives_version = 77").getInt(), 1);
  expectRefusal("experiment " + file("short.toml") + " --other-version --out " + file("x"), 2, {"--resume"});
}

TEST_F(GoingOn, PartsOfSeveralVersionsAreNotMergedUnlessWanted) {
  for (const char* shard : {"1", "2"})
    EXPECT_EQ(surefoot("experiment " + file("short.toml") + " --lives 4 --shard " + shard + "/2 --out " +
                       file(std::string("p") + shard))
                  .code,
              0);
  const std::string merge = "merge " + file("p1") + " " + file("p2") + " --out ";
  EXPECT_EQ(surefoot(merge + file("m0")).code, 0);
  sql(file("p2"), "UPDATE lives SET lives_version = 77");
  expectRefusal(merge + file("m1"), 3, {"p2", "77", "--other-version"});
  EXPECT_EQ(surefoot(merge + file("m1") + " --other-version").code, 0);
  sql(file("p1"), "UPDATE lives SET lives_version = NULL");
  expectRefusal(merge + file("m2"), 3, {"p1", "--other-version"});
}

TEST_F(GoingOn, ACheckpointOfAnotherVersionIsToldAndRefusedUnlessWanted) {
  const std::string life = file("life.st"), resume = "train --minutes 2 --resume " + life;
  run("train --minutes 1 --checkpoint " + life);
  EXPECT_EQ(surefoot(resume).code, 0);
  const std::string ours = std::to_string(kLivesVersion);
  ASSERT_EQ(ours.size(), 1u) << "the number in the file is replaced by one of the same length";
  ASSERT_NE(ours, "7");
  replaceIn(life, "\\\"lives_version\\\":" + ours, "\\\"lives_version\\\":7");
  expectRefusal(resume, 3, {"life.st", "number 7", "--other-version"});
  const auto gone = run(resume + " --other-version --checkpoint " + life);
  EXPECT_EQ(gone["lives"][0]["changes"][0]["key"], "lives_version");
  EXPECT_EQ(gone["lives"][0]["changes"][0]["before"], "7");
  EXPECT_EQ(surefoot("train --minutes 3 --resume " + life).code, 0) << "from now on it is this version's";
  expectRefusal("train --minutes 1 --other-version", 2, {"--resume"});
}

// The contents that RESULTS.md prints are those of any version: what a new version can do more is not in them.
TEST_F(GoingOn, ContentsAreThoseOfEarlierVersions) {
  std::ofstream(file("pinned.toml")) << "title = \"Two walks\"\nlives = 3\nreference = \"one\"\n[base]\n"
                                        "environment = \"pendulum\"\nepisodes = 40\n[[condition]]\nname = \"one\"\n"
                                        "[[condition]]\nname = \"two\"\npolicy = \"softmax\"\nagent = \"sarsa-2q\"\n";
  const Finished run = surefoot("experiment " + file("pinned.toml") + " --out " + file("pinned.sqlite"));
  EXPECT_NE(run.out.find("6 of 6 lives, content c601d7510c509164"), std::string::npos) << run.out << run.err;
}

TEST_F(GoingOn, TheSamePlanAndQFunctionInTwoFoldersAreTheSameLives) {
  const std::string plan =
      "lives = 2\n[base]\nminutes = 0.2\n[pre-learning]\nfile = \"q.st\"\n[[condition]]\n"
      "name = \"a\"\n";
  std::vector<std::string> contents;
  for (const char* place : {"A", "B"}) {
    fs::create_directory(file(place));
    std::ofstream(file(place) + "/plan.toml") << plan;
  }
  run("train --minutes 0.3 --save " + file("A/q.st"));
  fs::copy_file(file("A/q.st"), file("B/q.st"));
  for (const char* place : {"A", "B"})
    contents.push_back(contentOfRun(file(place) + "/plan.toml --out " + file(place) + "/r.sqlite"));
  EXPECT_EQ(contents[0], contents[1]);
  fs::rename(file("A"), file("C"));
  EXPECT_NE(contentOfRun(file("C/plan.toml") + " --resume --lives 3 --out " + file("C/r.sqlite")), "");
  for (const char* shard : {"1", "2"})
    contentOfRun(file(std::string(shard[0] == '1' ? "B" : "C")) + "/plan.toml --shard " + shard + "/2 --out " +
                 file(std::string("part") + shard));
  const Finished merged = surefoot("merge " + file("part1") + " " + file("part2") + " --out " + file("merged"));
  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_NE(merged.out.find(contents[0]), std::string::npos) << merged.out;
}

TEST_F(GoingOn, NoFileTellsWhereItWasMade) {
  const std::string here = fs::path(file("x")).parent_path().string();
  const std::string q = file("q.st");
  run("train --minutes 0.3 --save " + q);
  run("train --minutes 0.3 --load " + q + " --save " + file("r.st") + " --checkpoint " + file("c.st") + " --journal " +
      file("j.jsonl") + " --log " + file("l.csv"));
  run("train --minutes 0.3 --load " + file("r.st") + " --save " + file("s.st"));
  EXPECT_EQ(surefoot("resample " + q + " --set features.scale=0.5 --save " + file("coarse.st")).code, 0);
  std::ofstream(file("p.toml")) << "lives = 1\n[base]\nminutes = 0.1\n[pre-learning]\nfile = \"" << file("s.st")
                                << "\"\n[[condition]]\nname = \"a\"\n";
  contentOfRun(file("p.toml") + " --out " + file("r.sqlite"));
  EXPECT_EQ(surefoot("export " + file("r.sqlite") + " --csv " + file("csv")).code, 0);
  fs::remove(file("p.toml"));
  int looked = 0;
  for (const auto& entry : fs::recursive_directory_iterator(here)) {
    if (!entry.is_regular_file()) continue;
    EXPECT_EQ(contentOf(entry.path().string()).find(here), std::string::npos) << entry.path();
    ++looked;
  }
  EXPECT_GT(looked, 8);
  EXPECT_EQ(surefoot("replay " + file("j.jsonl") + " --verify").code, 0) << "what it began with lies beside it";
  fs::create_directory(file("elsewhere"));
  fs::rename(file("j.jsonl"), file("elsewhere/j.jsonl"));
  expectRefusal("replay " + file("elsewhere/j.jsonl"), 3, {"q.st", "beside the journal"});
}

}  // namespace surefoot
