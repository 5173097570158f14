// SPDX-License-Identifier: GPL-3.0-or-later
// `surefoot FILE` and `surefoot window FILE`.
#include "tests/app/program.h"

namespace surefoot {

TEST(Open, AFileInThePlaceOfACommandIsOpened) {
  const Folder folder;
  std::ofstream(folder.file("plan.toml")) << "lives = 3\n";
  // All is well but for the display.
  expectRefusal(folder.file("plan.toml"), 2, {"no display"});
  expectRefusal("window " + folder.file("plan.toml"), 2, {"no display"});
  expectRefusal("window --page lessons", 2, {"no display"});
  expectRefusal(folder.file("plain.toml"), 3, {"plain.toml", "cannot be read"});
  expectRefusal("session.surefoot", 3, {"session.surefoot", "cannot be read"});
  expectRefusal("window " + folder.file(""), 3, {"not a regular file"});
  expectRefusal("sesion", 2, {"no such command"});
}

TEST(Open, NothingThatBeginsALifeStandsBesideIt) {
  const Folder folder;
  std::ofstream(folder.file("plan.toml")) << "lives = 3\n";
  for (const char* other : {"--load x", "--set policy.epsilon=0", "--seed 3", "--lesson a", "--environment leo",
                            "--minutes 3", "--at 3:push=1", "--page live"})
    expectRefusal("window " + folder.file("plan.toml") + " " + other, 2,
                  {"plan.toml", std::string(other).substr(0, std::string(other).find(' '))});
  expectRefusal("window --new-window --reuse-window", 2, {"--new-window", "--reuse-window"});
  expectRefusal("window --reuse-window --turbo", 2, {"--reuse-window", "--turbo"});
  expectRefusal("window --page lesson", 2, {"--page", "lesson", "lessons"});
  expectRefusal("window --language fr", 2, {"--language", "fr", "en, nl or de"});
  expectRefusal("window --language nl " + folder.file("plan.toml"), 2, {"no display"});
}

}  // namespace surefoot
