// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/whole_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/folder.h"

namespace surefoot {

namespace {

class WholeFileTest : public testing::Test {
 protected:
  std::string path(const char* name) const { return folder.file(name); }
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder.file("")), std::filesystem::directory_iterator());
  }
  const Folder folder;
};

}  // namespace

TEST_F(WholeFileTest, AppearsWithItsWholeContent) {
  {
    auto file = WholeFile::createNew("--log", path("a.csv"));
    ASSERT_TRUE(file);
    EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
    ASSERT_TRUE(file->commit("one\ntwo\n"));
  }
  std::ifstream in(path("a.csv"));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "one\ntwo\n");
  EXPECT_EQ(files(), 1);
}

// The system takes the first thousand bytes, then refuses: what was taken is no file.
TEST_F(WholeFileTest, AWriteThatIsCutShortIsNoSuccess) {
  const auto writeLimited = [&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    _exit(writeWhole("file", path("a.csv"), std::string(5000, 'x')) ? 1 : 0);
  };
  EXPECT_EXIT(writeLimited(), testing::ExitedWithCode(0), "");
  EXPECT_FALSE(std::filesystem::exists(path("a.csv")));
}

TEST_F(WholeFileTest, WithoutCommitNothingIsLeft) {
  {
    const auto file = WholeFile::createNew("--log", path("a.csv"));
    ASSERT_TRUE(file);
  }
  EXPECT_EQ(files(), 0);
}

TEST_F(WholeFileTest, AnExistingFileIsRefusedAndKept) {
  std::ofstream(path("a.csv")) << "old";
  const auto file = WholeFile::createNew("--log", path("a.csv"));
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().kind, ErrorKind::File);
  EXPECT_EQ(std::filesystem::file_size(path("a.csv")), 3u);
}

TEST_F(WholeFileTest, AFileThatAppearedMeanwhileIsNotOverwritten) {
  auto file = WholeFile::createNew("--log", path("a.csv"));
  ASSERT_TRUE(file);
  std::ofstream(path("a.csv")) << "old";
  EXPECT_FALSE(file->commit("new"));
  EXPECT_EQ(std::filesystem::file_size(path("a.csv")), 3u);
}

TEST_F(WholeFileTest, AFolderThatIsNotThereIsNamed) {
  const auto file = WholeFile::createNew("--log", path("no/such/a.csv"));
  ASSERT_FALSE(file);
  EXPECT_NE(file.error().message.find("no/such/a.csv"), std::string::npos);
}

TEST_F(WholeFileTest, WhatAKilledProgramLeftGoesWithTheNextFile) {
  namespace fs = std::filesystem;
  const auto left = [&](const std::string& name, int secondsAgo) {
    const fs::path path = fs::path(this->path("x")).parent_path() / name;
    std::ofstream(path) << "half";
    fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::seconds(secondsAgo));
    return path;
  };
  const fs::path gone = left(".surefoot-2000000000-0", 7200), fresh = left(".surefoot-2000000000-1", 0),
                 ours = left(".surefoot-" + std::to_string(getpid()) + "-7", 7200),
                 other = left(".surefoot-notes", 7200);
  ASSERT_TRUE(writeWhole("file", path("x"), "content"));
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_TRUE(fs::exists(fresh)) << "another machine may be about to use it";
  EXPECT_TRUE(fs::exists(ours) && fs::exists(other));
}

}  // namespace surefoot
