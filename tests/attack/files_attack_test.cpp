// SPDX-License-Identifier: GPL-3.0-or-later
// Files made to harm, and places that cannot be written: a sentence and an exit code, in little memory and time.
#include "tests/app/program.h"

namespace surefoot {

namespace {

std::string times(int n, const std::string& text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

/// One sentence, the code and the words, within ten seconds and 4 GB of addresses.
void expectRefusalInBounds(const std::string& arguments, int code, const std::vector<std::string>& words) {
  const Folder folder;
  const std::string err = folder.file("err");
  const std::string command =
      "(ulimit -v 4000000; timeout 10 " SUREFOOT_PROGRAM " " + arguments + ") >/dev/null 2>" + err;
  const int status = std::system(command.c_str());
  const std::string said = contentOf(err);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, code) << arguments << "\n" << said;
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  for (const std::string& word : words) EXPECT_NE(said.find(word), std::string::npos) << arguments << "\n" << said;
}

std::string written(const std::string& path, const std::string& content) {
  std::ofstream(path) << content;
  return path;
}

}  // namespace

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
                              "/c >/dev/null 2>" + said + " & sleep 1; rm -r " + gone + "; wait $!";
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

}  // namespace surefoot
