// SPDX-License-Identifier: GPL-3.0-or-later
// Stores are found whatever happens to them, read while they are written, and tell what they lack.
#include "core/store/store.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/laboratory/laboratory.h"
#include "core/life/lives_version.h"
#include "core/saved/q_file.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

const std::string kStorePlan =
    "lives = 3\nseed = 5\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 30\n[[condition]]\n"
    "name = \"a\"\n";

class StoreTest : public testing::Test {
 protected:
  Plan plan(const std::string& text = kStorePlan, const std::string& path = "plan.toml") {
    auto made = parsePlan(registry, text, path, {});
    EXPECT_TRUE(made) << made.error().message;
    return *made;
  }
  Store make(const std::string& name) {
    auto store = Store::create(folder.file(name), *planToStore(registry, plan()));
    EXPECT_TRUE(store) << store.error().message;
    return std::move(*store);
  }
  static StoredLife life(int number) {
    return {.life = number,
            .episodes = 1,
            .steps = 7,
            .falls = 1,
            .diverged = {},
            .hash = 3,
            .livesVersion = kLivesVersion,
            .program = "0"};
  }
  static void save(Store& store, int number) {
    EXPECT_TRUE(store.save(life(number), {{7, -1.0, 1, EndingCode::Fall}}, {}));
  }
  /// What a process does with a store until it is killed, before it can tidy up.
  void killed(const std::string& name, const std::function<void(Store&)>& work) {
    const pid_t child = fork();
    if (child == 0) {
      auto store = Store::openToWrite(folder.file(name));
      if (store) work(*store);
      raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status));
  }
  void sql(const std::string& name, const std::string& text) {
    SQLite::Database(folder.file(name), SQLite::OPEN_READWRITE).exec(text);
  }
  /// As a store of the first days had it.
  void makeOld(const std::string& name) {
    sql(name,
        "ALTER TABLE lives DROP COLUMN lives_version; ALTER TABLE lives DROP COLUMN program; ALTER "
        "TABLE lives DROP COLUMN checksum; ALTER TABLE pre_learned DROP COLUMN checksum; DROP TABLE q_functions; "
        "DELETE FROM experiment WHERE key IN ('writing', 'plan_checksum', 'lives_checksum'); PRAGMA user_version = 1");
  }
  std::size_t livesIn(const std::string& name) {
    const auto store = Store::open(folder.file(name));
    EXPECT_TRUE(store) << store.error().message;
    return store ? store->lives()->size() : 0;
  }
  std::vector<std::string> filesOf(const std::string& name) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(folder.file("x")).parent_path()))
      if (entry.path().filename().string().starts_with(name)) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  Registry registry = fullRegistry();
  Folder folder;
};

}  // namespace

TEST_F(StoreTest, ARunningStoreIsReadByAnybodyAndTheWriterGoesOn) {
  Store writer = make("s");
  save(writer, 0);
  const auto reader = Store::open(folder.file("s"));
  ASSERT_TRUE(reader) << reader.error().message;
  EXPECT_EQ(reader->lives()->size(), 1u);
  EXPECT_EQ(reader->note(), "");
  SQLite::Database other(folder.file("s"), SQLite::OPEN_READONLY);  // as sqlite3 and Python do
  SQLite::Statement open(other, "SELECT life FROM lives");
  ASSERT_TRUE(open.executeStep()) << "it stands in the middle of its reading";
  save(writer, 1);
  EXPECT_TRUE(writer.settle());
  EXPECT_EQ(reader->lives()->size(), 2u);
  EXPECT_FALSE(Store::openToWrite(folder.file("s"))) << "one writes at a time";
}

TEST_F(StoreTest, AClosedStoreIsOneFile) {
  {
    Store store = make("s");
    save(store, 0);
  }
  EXPECT_EQ(filesOf("s"), (std::vector<std::string>{"s"}));
  EXPECT_EQ(livesIn("s"), 1u);
  EXPECT_EQ(filesOf("s"), (std::vector<std::string>{"s"})) << "reading leaves nothing";
}

TEST_F(StoreTest, AfterAKillEveryLifeIsFoundAndTheNextOneWrites) {
  { make("s"); }
  killed("s", [](Store& store) {
    for (int i = 0; i < 3; ++i) save(store, i);
  });
  EXPECT_EQ(livesIn("s"), 3u);
  auto next = Store::openToWrite(folder.file("s"));
  ASSERT_TRUE(next) << next.error().message;
  EXPECT_EQ(next->lives()->size(), 3u);
  EXPECT_EQ(next->note(), "");
}

TEST_F(StoreTest, ACopyWithoutItsLogHasWhatWasSettledAndTellsOfTheRest) {
  { make("s"); }
  killed("s", [](Store& store) {
    for (int i = 0; i < 2; ++i) save(store, i);
    EXPECT_TRUE(store.settle());
    save(store, 2);
  });
  fs::copy_file(folder.file("s"), folder.file("copy"));
  const auto copy = Store::open(folder.file("copy"));
  ASSERT_TRUE(copy) << copy.error().message;
  EXPECT_EQ(copy->lives()->size(), 2u);
  EXPECT_NE(copy->note().find("copy-wal"), std::string::npos) << copy->note();
  EXPECT_NE(copy->note().find("may be missing"), std::string::npos) << copy->note();
  EXPECT_EQ(filesOf("copy"), (std::vector<std::string>{"copy"})) << "looking at it leaves nothing beside it";
  {
    auto writer = Store::openToWrite(folder.file("copy"));
    ASSERT_TRUE(writer);
    EXPECT_NE(writer->note(), "");
    save(*writer, 2);
  }
  EXPECT_EQ(Store::open(folder.file("copy"))->note(), "") << "it is whole again";
  EXPECT_EQ(livesIn("copy"), 3u);
}

// As it is left when the program is killed while it changes over to the log.
TEST_F(StoreTest, AChangeThatWasCutOffIsUndoneForWhoeverReads) {
  {
    Store store = make("s");
    for (int i = 0; i < 3; ++i) save(store, i);
  }
  const std::uint64_t content = *Store::open(folder.file("s"))->contentHash();
  fs::copy_file(folder.file("s"), folder.file("working"));
  {
    SQLite::Database db(folder.file("working"), SQLite::OPEN_READWRITE);
    db.exec("PRAGMA journal_mode = DELETE; PRAGMA cache_size = 1; PRAGMA synchronous = FULL; BEGIN IMMEDIATE");
    db.exec("UPDATE lives SET falls = falls + 1; UPDATE conditions SET name = 'other' || name");
    db.exec("CREATE TABLE big(x); INSERT INTO big SELECT zeroblob(100000)");
    for (const char* part : {"", "-journal"}) fs::copy_file(folder.file("working") + part, folder.file("cut") + part);
    db.exec("ROLLBACK");
  }
  const auto files = filesOf("cut");
  ASSERT_EQ(files.size(), 2u);
  const auto cut = Store::open(folder.file("cut"));
  ASSERT_TRUE(cut) << cut.error().message;
  EXPECT_EQ(*cut->contentHash(), content);
  EXPECT_EQ(filesOf("cut"), files) << "looking at it changes nothing";
}

TEST_F(StoreTest, OfEqualStoresTheMarkIsNoContent) {
  Store writer = make("s");
  save(writer, 0);
  const auto open = *writer.contentHash();
  { Store(std::move(writer)); }
  EXPECT_EQ(*Store::open(folder.file("s"))->contentHash(), open);
}

TEST_F(StoreTest, NamesThatAnUriWouldReadOtherwiseAreNames) {
  for (const std::string name : {"a?b#c%41.sqlite", "mode=ro&x", "ü ä"}) {
    { make(name); }
    EXPECT_EQ(livesIn(name), 0u) << name;
  }
}

TEST_F(StoreTest, AStoreOfTheFirstFormatIsReadAndGoneOnWith) {
  {
    Store store = make("old");
    save(store, 0);
  }
  const auto hash = *Store::open(folder.file("old"))->contentHash();
  makeOld("old");
  {
    const auto old = Store::open(folder.file("old"));
    ASSERT_TRUE(old) << old.error().message;
    EXPECT_EQ(old->lives()->at(0).livesVersion, kLivesVersionUnknown);
    EXPECT_EQ(*old->contentHash(), hash);
    EXPECT_FALSE(checkLivesVersion(*old->lives(), "old"));
  }
  {
    auto writer = Store::openToWrite(folder.file("old"));
    ASSERT_TRUE(writer) << writer.error().message;
    save(*writer, 1);
    const auto lives = writer->lives();
    EXPECT_EQ(lives->at(0).livesVersion, kLivesVersionUnknown) << "each keeps its own";
    EXPECT_EQ(lives->at(1).livesVersion, kLivesVersion);
  }
  EXPECT_EQ(livesIn("old"), 2u);
}

TEST_F(StoreTest, AQFunctionCountsByItsValuesWhereverItLies) {
  std::vector<std::string> texts;
  std::vector<std::uint64_t> seeds, hashes;
  Configuration c = *configure(registry, {.environment = "cliff", .features = "table"}, {});
  c.episodes = 5;
  auto life = makeLife(registry, c, 0, false);
  while (!(*life)->finished()) (*life)->step();
  for (const std::string name : {"one", "two"}) {
    fs::create_directory(folder.file(name));
    TensorFile q = qFileOf(**life, c);
    if (name == "two") q.about["began_with"] = {{"file", "/home/somebody/old.safetensors"}, {"hash", "0"}};
    std::ofstream(folder.file(name + "/" + name + ".safetensors"), std::ios::binary) << q.write();
    const std::string text = kStorePlan + "pre-learning.file = \"" + name + ".safetensors\"\n";
    const Plan p = plan(text, folder.file(name + "/plan.toml"));
    texts.push_back(p.conditions[0].text);
    seeds.push_back(p.conditions[0].configuration.seed);
    auto store = Store::create(folder.file(name + ".sqlite"), *planToStore(registry, p));
    ASSERT_TRUE(store) << store.error().message;
    ASSERT_TRUE(runPlan(registry, p, *store, {.jobs = 2}));
    hashes.push_back(*store->contentHash());
  }
  EXPECT_EQ(texts[0], texts[1]);
  EXPECT_EQ(seeds[0], seeds[1]);
  EXPECT_EQ(hashes[0], hashes[1]);
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(folder.file("one.sqlite")).parent_path())) {
    if (!entry.is_regular_file()) continue;
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(bytes.find(fs::path(folder.file("x")).parent_path().string()), std::string::npos)
        << entry.path() << " tells where it was made";
  }
  // The store holds the Q-function, so that it can be gone on with wherever it is.
  fs::remove_all(folder.file("one"));
  auto store = Store::openToWrite(folder.file("one.sqlite"));
  auto again = planFromStore(registry, *store);
  ASSERT_TRUE(again) << again.error().message;
  const Plan more = plan(kStorePlan + "pre-learning.file = \"two.safetensors\"\n", folder.file("two/plan.toml"));
  again->lives = 4;
  ASSERT_TRUE(store->setLives(4));
  ASSERT_TRUE(runPlan(registry, *again, *store, {}));
  auto life3 = makeLife(registry, more.conditions[0].configuration, 3, false);
  while (!(*life3)->finished()) (*life3)->step();
  EXPECT_EQ(store->lives()->at(3).hash, (*life3)->hash());
}

TEST_F(StoreTest, APlanWithoutAFileKeepsItsSeeds) {
  EXPECT_EQ(plan().conditions[0].text,
            "environment=cliff agent=sarsa features=table policy=epsilon-greedy episodes=30");
}

}  // namespace surefoot
