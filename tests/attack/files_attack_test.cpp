// SPDX-License-Identifier: GPL-3.0-or-later
// Files made to harm, and places that cannot be written: a sentence and an exit code, in little memory and time.
#include <cmath>
#include <cstring>

#include "tests/attack/attack.h"

namespace surefoot {

TEST(FilesAttack, DeepJsonIsRefused) {
  const Folder folder;
  const std::string journal = folder.file("good.jsonl"), deep = folder.file("deep.jsonl");
  ASSERT_EQ(surefoot("train --environment cliff --features table --episodes 5 --journal " + journal).code, 0);
  std::string text = contentOf(journal);
  text.insert(text.find('{') + 1, "\"x\":" + times(100'000, "[") + times(100'000, "]") + ",");
  written(deep, text);
  for (const std::string& command : {"replay " + deep, "train --from " + deep + " --episodes 5"})
    expectRefusalInBounds(command, 3, {"deep.jsonl"});
}

TEST(FilesAttack, JournalsWithoutEndAreRefused) {
  const Folder folder;
  const std::string journal = folder.file("good.jsonl");
  ASSERT_EQ(surefoot("train --environment cliff --features table --episodes 5 --journal " + journal).code, 0);
  const std::string good = contentOf(journal);
  const auto end = good.find("{\"end\"");
  const std::string many = good.substr(0, end) +
                           times(600'000, "{\"key\":\"policy.epsilon\",\"step\":1,\"value\":\"0.1\"}\n") +
                           good.substr(end);
  expectRefusalInBounds("replay " + written(folder.file("many.jsonl"), many), 3, {"10000 commands"});
  std::string late = good;
  const auto step = late.find("\"step\":", end) + 7;
  late.replace(step, late.find_first_of(",}", step) - step, "9223372036854775807");
  expectRefusalInBounds("replay " + written(folder.file("late.jsonl"), late), 3, {"more steps"});
}

TEST(FilesAttack, DeepTomlIsRefused) {
  const Folder folder;
  for (const std::string& text : {times(200'000, "a.") + "a = 1\n", "[" + times(200'000, "a.") + "a]\n",
                                  "a = " + times(200'000, "["), "a = " + times(200'000, "{b=")}) {
    expectRefusalInBounds("experiment --dry-run " + written(folder.file("deep.toml"), text), 2,
                          {"deep.toml", "line 1"});
  }
}

TEST(FilesAttack, AFileSystemWithoutLinksTakesEveryFile) {
  const Folder folder;
  const std::string preload = "LD_PRELOAD=" SUREFOOT_NO_LINKS " ";
  const std::string save = folder.file("q.safetensors"), log = folder.file("l.csv"),
                    checkpoint = folder.file("c.safetensors");
  const std::string command = preload + SUREFOOT_PROGRAM +
                              " train --environment cliff --features table --episodes 20 --save " + save + " --log " +
                              log + " --checkpoint " + checkpoint + " >/dev/null 2>" + folder.file("err");
  EXPECT_EQ(std::system(command.c_str()), 0) << contentOf(folder.file("err"));
  for (const std::string& file : {save, checkpoint}) EXPECT_EQ(surefoot("inspect " + file).code, 0) << file;
  EXPECT_GT(contentOf(log).size(), 100u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("")), {}), 4);  // and err
  const std::string before = contentOf(save);
  EXPECT_NE(std::system(command.c_str()), 0);  // the names are taken
  EXPECT_EQ(contentOf(save), before);
}

TEST(FilesAttack, EveryResultThatCannotBeWrittenIsKeptElsewhere) {
  const Folder folder;
  const std::string gone = folder.file("gone"), said = folder.file("said"), here = folder.file("here");
  std::filesystem::create_directory(gone);
  std::filesystem::create_directory(here);
  const std::string command = "cd " + here + "; timeout -s INT 3 " SUREFOOT_PROGRAM " train --minutes 1000000 --save " +
                              gone + "/q --log " + gone + "/l.csv --journal " + gone + "/j.jsonl --checkpoint " + gone +
                              "/c >/dev/null 2>" + said + " & sleep 1; while test -e " + gone + "; do rm -rf " + gone +
                              "; done; wait $!";  // a checkpoint may come into it meanwhile
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 124);  // timeout's own
  const std::string err = contentOf(said);
  for (const char* name : {"q-", "l.csv-", "j.jsonl-", "c-"}) {
    bool found = false;
    for (const auto& entry : std::filesystem::directory_iterator(here))
      found |= entry.path().filename().string().starts_with(name) && entry.file_size() > 0;
    EXPECT_TRUE(found) << name << "\n" << err;
    EXPECT_NE(err.find(std::string(name)), std::string::npos) << err;
  }
}

TEST(FilesAttack, ASignalThatIsIgnoredAtTheStartStaysIgnored) {
  const Folder folder;
  const std::string code = folder.file("code");
  // As nohup does; then SIGTERM, which ends it in order.
  const std::string command = "(trap '' HUP; " SUREFOOT_PROGRAM
                              " train --minutes 1000000 >/dev/null 2>&1 & p=$!; sleep 0.7; kill -HUP $p; "
                              "sleep 0.5; kill -0 $p && echo alive >" +
                              folder.file("alive") + "; kill -TERM $p; wait $p; echo $? >" + code + ")";
  ASSERT_NE(std::system(command.c_str()), -1);
  EXPECT_EQ(contentOf(folder.file("alive")), "alive\n");
  EXPECT_EQ(contentOf(code), "130\n");
}

namespace {

/// A safetensors file of these tensors, whose data is a hole.
std::string sparse(const std::string& path, const nlohmann::json& about, const nlohmann::json& tensors,
                   std::size_t size) {
  nlohmann::json header = tensors;
  header["__metadata__"] = {{"surefoot", about.dump()}};
  const std::string text = header.dump();
  const std::uint64_t length = text.size();
  std::ofstream(path, std::ios::binary) << std::string(reinterpret_cast<const char*>(&length), 8) << text;
  std::filesystem::resize_file(path, 8 + length + size);
  return path;
}

nlohmann::json tensor(const std::vector<std::size_t>& shape, std::size_t begin, std::size_t end) {
  return {{"dtype", "F64"}, {"shape", shape}, {"data_offsets", {begin, end}}};
}

}  // namespace

TEST(FilesAttack, NothingIsReadThatNobodyAskedFor) {
  const Folder folder;
  const std::string good = folder.file("good.safetensors");
  ASSERT_EQ(surefoot("train --environment cliff --features table --episodes 5 --save " + good).code, 0);
  const nlohmann::json about = run("inspect " + good)["about"];
  constexpr std::size_t kCount = 200'000'000, kBytes = 8 * kCount;
  nlohmann::json other = about, later = about;
  other["kind"] = "something";
  later["format"] = "2.0";
  const std::string hole = folder.file("hole.safetensors");
  const nlohmann::json weights = {{"q.weights", tensor({kCount / 4, 4}, 0, kBytes)}},
                       more = {{"q.more", tensor({kCount}, 0, kBytes)}}, strange = {{"x", tensor({kCount}, 0, kBytes)}};
  for (const auto& [description, tensors, word] : {std::tuple{other, weights, "of the kind"},
                                                   {later, weights, "its format"},
                                                   {about, weights, "does not fit"},
                                                   {about, more, "is none that an estimate has"},
                                                   {about, strange, "belongs to none"}}) {
    sparse(hole, description, tensors, kBytes);
    for (const char* command : {"inspect ", "query --state 0,0 ", "train --episodes 5 --load "})
      expectRefusalInBounds(command + hole, 3, {"hole.safetensors", word}, 600'000);
  }
}

TEST(FilesAttack, InspectRefusesWhatCannotBeLoaded) {
  const Folder folder;
  const std::string good = folder.file("good.safetensors"), bad = folder.file("bad.safetensors");
  ASSERT_EQ(surefoot("train --environment cliff --features table --episodes 5 --save " + good).code, 0);
  EXPECT_EQ(surefoot("inspect " + good).code, 0);
  std::string bytes = contentOf(good);
  const auto checksum = bytes.find("\\\"checksum\\\"");  // whoever changes a file may take it out
  ASSERT_NE(checksum, bytes.npos);
  bytes.replace(checksum, 12, "\\\"checkXum\\\"");
  const double nan = std::nan("");
  std::memcpy(bytes.data() + bytes.size() - sizeof nan, &nan, sizeof nan);
  for (const char* command : {"inspect ", "query --state 0,0 "})
    expectRefusalInBounds(command + written(bad, bytes), 3, {"bad.safetensors", "not a finite number"});
}

TEST(FilesAttack, ValuesThatAreEmptyAreRefused) {
  const Folder folder;
  for (const char* setting : {"pre-learning.file", "reference", "environment", "policy", "features", "agent"}) {
    const std::string plan =
        written(folder.file("plan.toml"),
                "lives = 2\n[base]\nfeatures = \"table\"\nepisodes = 5\n[[condition]]\nname = \"a\"\n" +
                    std::string(setting) + " = \"\"\n");
    expectRefusalInBounds("experiment --dry-run " + plan, 2, {"plan.toml", setting});
  }
}

TEST(FilesAttack, ManyConditionsAreCountedFirst) {
  const Folder folder;
  std::string list;
  for (int i = 1; i <= 101; ++i) list += (i > 1 ? "," : "") + std::to_string(i / 200.0);
  const std::string head = "[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 5\n[[condition]]\n",
                    two = "set.policy.epsilon = [" + list + "]\nset.agent.discount = [" + list + "]\n";
  expectRefusalInBounds("experiment --dry-run " + written(folder.file("many.toml"), head + two), 2,
                        {"many.toml", "more than 10000 conditions"});
}

TEST(FilesAttack, ALogThatNoMemoryHoldsIsRefusedBefore) {
  const Folder folder;
  expectRefusalInBounds("train --environment cliff --features table --episodes 1000000000 --checkpoint " +
                            folder.file("c") + " --log " + folder.file("l.csv"),
                        2, {"--checkpoint with --log", "GB of memory"});
  EXPECT_FALSE(std::filesystem::exists(folder.file("l.csv")));
}

// As old disks have them: the name is taken as it is and shown with escapes, and no life ends with an exception.
TEST(Attack, NamesThatAreNoUtf8AreNamesOfFiles) {
  const Folder folder;
  const std::string name = "'" + folder.file("") + "'$(printf 'bad\\377\\303')";
  const auto works = [&](const std::string& command, const std::string& says) {
    const Finished run = surefootInBounds(command);
    EXPECT_EQ(run.code, 0) << command << "\n" << run.err;
    EXPECT_NE(run.out.find(says), std::string::npos) << command << "\n" << run.out;
  };
  works("train --episodes 20 --json --save " + name + ".q --log " + name + ".csv --journal " + name +
            ".jsonl --checkpoint " + name + ".ckpt",
        "\"lives\"");
  works("train --episodes 5 --json --load " + name + ".q", "\"lives\"");
  works("train --episodes 30 --resume " + name + ".ckpt", "falls");
  works("replay " + name + ".jsonl", "hash");
  works("inspect " + name + ".q", "q-function");
  written(folder.file("plan.toml"),
          "lives = 1\n[[condition]]\nname = \"a\"\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 5\n");
  works("experiment " + folder.file("plan.toml") + " --json --out " + name + ".sqlite", "content_hash");
  works("statistics --json " + name + ".sqlite", "conditions");
  expectRefusalInBounds("train --minutes 1 --log " + name + ".csv", 3, {"bad\\xff\\xc3.csv", "exists already"});
}

}  // namespace surefoot
