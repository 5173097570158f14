// SPDX-License-Identifier: GPL-3.0-or-later
// Stores from elsewhere, and stores that were damaged.
#include <SQLiteCpp/SQLiteCpp.h>

#include <random>

#include "tests/attack/attack.h"

namespace surefoot {

namespace {

class StoresAttack : public testing::Test {
 protected:
  void SetUp() override {
    const std::string plan = written(
        folder.file("plan.toml"),
        "lives = 3\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 20\n[[condition]]\nname = \"a\"\n"
        "[[condition]]\nname = \"b\"\nset.policy.epsilon = 0.2\n");
    ASSERT_EQ(surefoot("experiment " + plan + " --out " + good).code, 0);
  }
  /// A copy of the good store in which something is another.
  std::string with(const std::string& sql) {
    const std::string path = folder.file("bad.sqlite");
    std::filesystem::copy_file(good, path, std::filesystem::copy_options::overwrite_existing);
    SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
    return path;
  }
  /// As a store of format 1, which has no checksums.
  std::string oldWith(const std::string& sql) {
    return with(
        "ALTER TABLE lives DROP COLUMN lives_version; ALTER TABLE lives DROP COLUMN program; "
        "ALTER TABLE lives DROP COLUMN checksum; ALTER TABLE pre_learned DROP COLUMN checksum; "
        "DROP TABLE q_functions; DELETE FROM experiment WHERE key IN ('writing', 'plan_checksum', "
        "'lives_checksum'); PRAGMA user_version = 1; " +
        sql);
  }
  void expectDamaged(const std::string& store, const std::vector<std::string>& words) {
    for (const std::string& command : {"statistics " + store, "export " + store + " --csv " + folder.file("csv"),
                                       "experiment " + folder.file("plan.toml") + " --lives 4 --resume --out " + store,
                                       "merge --other-version " + store + " --out " + folder.file("merged.sqlite")})
      expectRefusalInBounds(command, 3, words);
  }

  const Folder folder;
  const std::string good = folder.file("good.sqlite");
};

}  // namespace

TEST_F(StoresAttack, GoodOnesAreRead) {
  EXPECT_EQ(surefootInBounds("statistics " + good).code, 0);
  const Finished old = surefootInBounds("statistics " + oldWith(""));
  EXPECT_EQ(old.code, 0) << old.err;
  EXPECT_NE(old.err.find("without checksums"), std::string::npos) << old.err;
  const std::string store = oldWith("");
  const Finished resumed =
      surefoot("experiment " + folder.file("plan.toml") + " --resume --other-version --out " + store);
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(surefootInBounds("statistics " + store).err, "");  // it has its checksums now
}

TEST_F(StoresAttack, TablesThatAreNotOursAreRefused) {
  for (const char* sql :
       {"CREATE TRIGGER t AFTER INSERT ON lives BEGIN UPDATE lives SET falls = 0; END",
        "ALTER TABLE episodes RENAME TO e; CREATE VIEW episodes AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT "
        "i + 1 FROM n) SELECT 0 AS condition, 0 AS life, i AS episode, 1 AS transitions, 0.0 AS reward, 0 AS falls, 0 "
        "AS "
        "ending FROM n",
        "CREATE TABLE other (x)", "CREATE INDEX i ON episodes (reward)",
        "ALTER TABLE lives ADD COLUMN more INTEGER GENERATED ALWAYS AS (falls + 1) VIRTUAL", "DROP TABLE endings"}) {
    expectDamaged(with(sql), {"bad.sqlite", "such a store is not read"});
    expectDamaged(oldWith(sql), {"bad.sqlite", "such a store is not read"});
  }
}

TEST_F(StoresAttack, NumbersThatMakeNoSenseAreRefused) {
  for (const auto& [sql, word] : std::initializer_list<std::pair<const char*, const char*>>{
           {"UPDATE lives SET life = -1 - life", "life is -"},
           {"UPDATE lives SET condition = 7 WHERE condition = 1", "condition is 7"},
           {"UPDATE lives SET falls = falls + 4294967296", "falls"},
           {"UPDATE lives SET falls = 1e300", "falls is no whole number"},
           {"UPDATE lives SET hash = 'f'", "hash is"},
           {"UPDATE episodes SET ending = -7", "ending is -7"},
           {"UPDATE episodes SET reward = 9e999", "reward is inf"},
           {"UPDATE episodes SET falls = 5", "falls"},
           {"UPDATE episodes SET transitions = 'many'", "transitions is no whole number"},
           {"DELETE FROM episodes WHERE episode = 20", "19 of 20 episodes"},
           {"DELETE FROM episodes WHERE episode = 3", "episode is 4"},
           {"UPDATE conditions SET step_time = -9e999, goal_reward = 9e999", "goal_reward is inf"},
           {"UPDATE conditions SET step_time = -1", "step_time"},
           {"UPDATE conditions SET lives = 0", "lives is 0"},
           {"UPDATE conditions SET name = cast(x'ff' AS TEXT)", "name is no UTF-8"},
           {"UPDATE conditions SET configuration = replace(configuration, '\"cliff\"', '7')", "environment is no name"},
           {"UPDATE conditions SET configuration = '[' || configuration || ']'", "no configuration"},
           {"UPDATE experiment SET value = '-1' WHERE key = 'seed'", "seed is \"-1\""},
           {"UPDATE experiment SET value = 'x' WHERE key = 'shards'", "shards is \"x\""},
           {"DELETE FROM conditions", "condition"}}) {
    expectDamaged(oldWith(sql), {"bad.sqlite", word, "the file is damaged"});
    expectDamaged(with(sql), {"bad.sqlite", "the file is damaged"});
  }
}

TEST_F(StoresAttack, NumbersThatWereChangedAreRefused) {
  for (const char* sql :
       {"UPDATE episodes SET reward = reward + 1 WHERE episode = 3",
        "UPDATE lives SET states_outside = 1 WHERE life = 2", "UPDATE lives SET hash = '0123456789abcdef'",
        "DELETE FROM lives WHERE life = 1", "UPDATE conditions SET goal_reward = goal_reward + 1",
        "UPDATE experiment SET value = '2' WHERE key = 'seed'",
        "INSERT INTO measures VALUES (0, 0, 0, 'walks_after', 1.0)"})
    expectDamaged(with(sql), {"bad.sqlite", "the file is damaged"});
}

// 200 single bits, each elsewhere: refused, or without any effect.
TEST_F(StoresAttack, NoBitThatFlipsMakesOtherNumbers) {
  const std::string right = surefoot("statistics --json " + good).out, bytes = contentOf(good);
  ASSERT_GT(right.size(), 100u);
  std::mt19937_64 random(5);
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::string flipped = bytes;
    const std::uint64_t bit = random() % (8 * bytes.size());
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    const Finished run = surefootInBounds("statistics --json " + written(folder.file("flip.sqlite"), flipped));
    refused += run.code == 3;
    if (run.code != 3) {
      EXPECT_EQ(run.code, 0) << "bit " << bit << "\n" << run.err;
      EXPECT_EQ(run.out, right) << "bit " << bit;
    }
  }
  EXPECT_GT(refused, 20);
}

TEST_F(StoresAttack, NamesAreCodeToNobody) {
  const std::string names[] = {"a\x1b]0;pwned\x07\x1b[31mred\x1b[2J",
                               "\xc2\x9b"
                               "31m \xe2\x80\xae turned",
                               "=HYPERLINK(\"http://x\",\"y\")", "\\input{/etc/passwd}",
                               "<img src=\"file:///dev/zero\">"};
  for (const std::string& name : names) {
    std::string quoted;
    for (const char c : name) quoted += c == '\'' ? "''" : std::string(1, c);
    const std::string store = oldWith("UPDATE conditions SET name = '" + quoted + "' WHERE condition = 0");
    for (const char* form : {"", "--csv ", "--latex ", "--json "}) {
      const Finished shown = surefootInBounds("statistics " + std::string(form) + store);
      EXPECT_EQ(shown.code, 0) << shown.err;
      for (const char* harmful : {"\x1b", "\x07", "\xc2\x9b", "\xe2\x80\xae"})
        EXPECT_EQ(shown.out.find(harmful), std::string::npos) << form << shown.out;
      if (std::string(form) == "--csv ") {
        EXPECT_EQ(shown.out.find("\n="), std::string::npos) << shown.out;
      }
      if (std::string(form) == "--latex ") {
        EXPECT_EQ(shown.out.find("\\input"), std::string::npos) << shown.out;
      }
    }
    const std::string folderOfTables = folder.file("tables");
    std::filesystem::remove_all(folderOfTables);
    EXPECT_EQ(surefoot("export " + store + " --csv " + folderOfTables).code, 0);
    EXPECT_EQ(contentOf(folderOfTables + "/conditions.csv").find(",="), std::string::npos);
    EXPECT_EQ(contentOf(folderOfTables + "/conditions.csv").find(",\"="), std::string::npos);
  }
}

TEST_F(StoresAttack, AKilledMergeIsClearedByTheNext) {
  const std::string out = folder.file("all.sqlite");
  for (const char* rest : {".merging", ".merging-wal", ".merging-lock"}) written(out + rest, "litter");
  EXPECT_EQ(surefoot("merge " + good + " --out " + out).code, 0);
  for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
    EXPECT_EQ(entry.path().filename().string().find("merging"), std::string::npos) << entry.path();
}

TEST_F(StoresAttack, OneInterruptEndsReading) {
  SQLite::Database db(good, SQLite::OPEN_READWRITE);
  db.exec(
      "WITH RECURSIVE n(i) AS (SELECT 21 UNION ALL SELECT i + 1 FROM n LIMIT 4000000) INSERT INTO episodes SELECT 0, "
      "0, i, 1, 0.0, 0, 0 FROM n");
  const std::string code = folder.file("code");
  const std::string command =
      "timeout -s INT 0.3 " SUREFOOT_PROGRAM " statistics " + good + " >/dev/null 2>" + folder.file("err") + "; true";
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
  EXPECT_NE(contentOf(folder.file("err")).find("interrupted"), std::string::npos) << contentOf(folder.file("err"));
}

}  // namespace surefoot
