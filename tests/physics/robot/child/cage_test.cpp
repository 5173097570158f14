// SPDX-License-Identifier: GPL-3.0-or-later
// What a program in a cage can see: its own folder, the system and what programs need to run, and nothing else of the
// person who starts it.
#include "physics/robot/child/cage.h"

#include "physics/robot/child/cage_folders.h"
#include "tests/physics/robot/child/programs.h"

namespace surefoot {

namespace {

namespace fs = std::filesystem;

/// A variable of the environment, for as long as this lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* now = std::getenv(name)) before_ = now;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_)
      setenv(name_, before_->c_str(), 1);
    else
      unsetenv(name_);
  }
  Variable(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

/// A home as people have them, behind a symbolic link; the system's programs are in PATH, too.
struct Home {
  Home() {
    const fs::path real = folder.file("disk/ann");
    for (const char* one :
         {".local/bin", ".local/lib/python3.11", ".local/share/keyrings", ".cargo/bin", "conda/bin", "conda/lib",
          "conda/pkgs", ".pyenv/shims", ".pyenv/versions", "bin", "robots/car", "tools/bin", "tools/lib"})
      fs::create_directories(real / one);
    for (const char* one : {".cargo/credentials.toml", ".local/share/keyrings/login", "tools/bin/simulator", "letter"})
      std::ofstream(real / one) << "secret";
    fs::create_symlink(real, folder.file("ann"));
    path = fs::canonical(real).string();
    home.emplace("HOME", folder.file("ann"));
    std::string list;
    for (const char* one : {".local/bin", ".cargo/bin", "conda/bin", ".pyenv/shims", "bin"})
      list += folder.file("ann") + "/" + one + ":";
    paths.emplace("PATH", list + std::getenv("PATH"));
  }

  Folder folder;
  std::string path;
  std::optional<Variable> home, paths;
};

}  // namespace

TEST(Cage, ShowsOfAHomeOnlyWhatPrograms) {
  const Home home;
  std::set<std::string> shown;
  for (const fs::path& one : shownFolders(home.path + "/tools/bin/simulator", home.path + "/robots/car"))
    if (one.string().starts_with(home.path)) shown.insert(one.string().substr(home.path.size() + 1));
  EXPECT_EQ(shown, (std::set<std::string>{".cargo/bin", ".local/bin", ".local/lib", ".pyenv", ".pyenv/shims", "bin",
                                          "conda/bin", "conda/lib", "tools/bin", "tools/bin/simulator", "tools/lib"}));
  EXPECT_TRUE(hiddenFolders().contains(home.path)) << "behind the link";
}

TEST(Cage, TakesNoFolderThatShowsAllOfAHome) {
  const Home home;
  EXPECT_TRUE(checkCageFolder(home.path + "/robots/car"));
  const Status whole = checkCageFolder(home.path), above = checkCageFolder("/");
  ASSERT_FALSE(whole);
  EXPECT_NE(whole.error().message.find("into a folder of their own"), std::string::npos) << whole.error().message;
  EXPECT_FALSE(above);
}

TEST(Cage, AProgramReadsNothingElseAndWritesNowhereElse) {
  if (!hasCage()) GTEST_SKIP() << "there is no bubblewrap, or it may not make cages here";
  const Home home;
  const std::string seen = home.folder.file("seen");
  const std::string look = R"(
import os, surefoot_child
HOME = os.environ["HOME"]
def reads(path):
    try:
        open(path).read()
        return True
    except OSError:
        return False
def writes(path):
    try:
        open(path, "w").write("x")
        return True
    except OSError:
        return False
class Look:
    def reset(self, random, parameters):
        self.seen = [reads("robot.py"), reads(HOME + "/.cargo/credentials.toml"), reads(HOME + "/letter"),
                     reads(HOME + "/.local/share/keyrings/login"), writes("robot.py"), writes("/tmp/x"),
                     writes("/var/tmp/x"), writes("/etc/x")]
        return [0, 0]
    def step(self, levels):
        raise RuntimeError(" ".join("+" if one else "-" for one in self.seen))
surefoot_child.serve(Look())
)";
  const ProgramHouse house(R"(["python3", "robot.py"])", look);
  const auto life = house.life();
  life->begin();
  life->step();
  EXPECT_NE(life->unanswered().find("RuntimeError: + - - - - + - -"), std::string::npos) << life->unanswered();
}

}  // namespace surefoot
