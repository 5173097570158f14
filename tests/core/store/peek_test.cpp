// SPDX-License-Identifier: GPL-3.0-or-later
// A store that is looked at while another process writes it (Store::peek).
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "core/life/lives_version.h"
#include "core/store/store.h"
#include "tests/core/experiment/test_setup.h"
#include "tests/folder.h"

namespace surefoot {

TEST(StorePeek, IsACopyOfOneMomentWhileLivesAreWritten) {
  constexpr int kLives = 400;
  const Folder folder;
  const std::string path = folder.file("live");
  const Registry registry = fullRegistry();
  const auto plan = parsePlan(registry,
                              "lives = 400\n[base]\nenvironment = \"cliff\"\nfeatures = \"table\"\nepisodes = 30\n"
                              "[[condition]]\nname = \"a\"\n",
                              "plan.toml", {});
  ASSERT_TRUE(plan) << plan.error().message;
  const pid_t child = fork();
  if (child == 0) {
    {
      auto store = Store::create(path, *planToStore(registry, *plan));
      StoredLife life{.episodes = 1, .steps = 7, .falls = 1, .diverged = {}, .livesVersion = kLivesVersion};
      for (; store && life.life < kLives; ++life.life) {
        static_cast<void>(static_cast<bool>(store->save(life, {{7, -1.0, 1, EndingCode::Fall}}, {})));
        if (life.life % 7 == 0) static_cast<void>(static_cast<bool>(store->settle()));
        usleep(1000);
      }
    }
    _exit(0);
  }
  std::size_t before = 0, looks = 0;
  for (int status = 0; waitpid(child, &status, WNOHANG) == 0;) {
    const auto store = Store::peek(path);
    if (!store) {  // not there yet, or too fast
      const std::string& why = store.error().message;
      EXPECT_TRUE(why.find("no such store") != std::string::npos || why.find("faster") != std::string::npos) << why;
      continue;
    }
    const auto lives = store->lives();
    ASSERT_TRUE(lives) << lives.error().message;
    EXPECT_GE(lives->size(), before);
    before = lives->size();
    ++looks;
  }
  EXPECT_GT(looks, 3u);
  EXPECT_EQ(Store::peek(path)->lives()->size(), static_cast<std::size_t>(kLives));
  EXPECT_FALSE(std::filesystem::exists(path + "-wal"));
}

}  // namespace surefoot
